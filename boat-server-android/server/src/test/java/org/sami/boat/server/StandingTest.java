package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.boat.server.vehicle.LocalFrame;

/** Whether what the speed's control has learned moves a boat on that is to stand: it learns what current and wear take. */
class StandingTest {
    private static final LocalFrame FRAME = new LocalFrame(45, 10);
    private static final double WANTED_MPS = 1.5;

    private final ServerTestBench bench = new ServerTestBench();
    private ServerTestBench.Client commander;

    @BeforeEach
    void driveNorth() {
        commander = bench.commander();
        commander.command(new UploadWaypoints(
                "c1", "l1", List.of(new Waypoint(FRAME.latDeg(0, 100), FRAME.lonDeg(0, 100), WANTED_MPS))));
        commander.command(new StartWaypoints("c2", "l1", 0));
    }

    /** On a boat that has learned nothing yet, at the same speed. */
    private static double thrustToStop(double speedMps) {
        StandingTest other = new StandingTest();
        other.driveNorth();
        other.bench.vehicle.speedMps = speedMps;
        return other.thrustToStop();
    }

    /** Tells of boats all around, so that it has to stop. */
    private double thrustToStop() {
        commander.say(new Traffic(
                List.of(boat("boat2", 0, 3.4), boat("boat3", -3.4, 0), boat("boat4", 3.4, 0), boat("boat5", 0, -3.4))));
        bench.run(0.1, commander);
        assertThat(bench.vehicle.rudder()).as("it stops straight on").isCloseTo(0, within(1e-6));
        return bench.vehicle.thrust();
    }

    private static NearbyBoat boat(String id, double eastM, double northM) {
        return new NearbyBoat(id, FRAME.latDeg(eastM, northM), FRAME.lonDeg(eastM, northM), 0, 0, BoatMode.STOPPED, 0);
    }

    @Test
    void boatDrivesOnAgainstACurrentByWhatItHasLearned() {
        bench.vehicle.speedMps = WANTED_MPS - 0.3;
        bench.run(1, commander);
        double before = bench.vehicle.thrust();

        bench.run(20, commander);

        assertThat(bench.vehicle.thrust())
                .isCloseTo(before + 0.3, within(0.01)); // 20 s at 0.05 for each m/s and second
    }

    @Test
    void boatThatIsToStopForgetsWhatKeptItGoing() {
        bench.vehicle.speedMps = WANTED_MPS - 0.3;
        bench.run(20, commander);

        assertThat(thrustToStop()).isCloseTo(thrustToStop(WANTED_MPS - 0.3), within(1e-6));
    }

    @Test
    void boatThatIsToStopGoesOnHoldingAgainstWhatCarriedIt() {
        bench.vehicle.speedMps = WANTED_MPS + 0.3;
        bench.run(20, commander);

        assertThat(thrustToStop()).isLessThan(thrustToStop(WANTED_MPS + 0.3) - 0.2);
    }

    @Test
    void boatThatStandsLearnsToHoldAgainstACurrent() {
        bench.vehicle.speedMps = 0;
        thrustToStop();
        bench.vehicle.speedMps = -0.3;
        for (int i = 0; i < 20; i++) {
            bench.run(1, commander);
            thrustToStop();
        }

        assertThat(bench.vehicle.thrust()).isGreaterThan(0.3 * 0.3 + 0.25);
    }

    /** As one does that begins to turn now to this side and now to that, among others; it learned up to full thrust so. */
    @ParameterizedTest
    @ValueSource(doubles = {1.2, -1.2})
    void boatLearnsNothingWhileItsSteeringTakesAllThrust(double offRad) {
        bench.vehicle.headingRad = offRad;
        bench.run(20, commander);
        assertThat(bench.vehicle.thrust()).isZero();

        bench.vehicle.headingRad = 0;
        bench.vehicle.speedMps = WANTED_MPS;
        bench.run(0.1, commander);

        assertThat(bench.vehicle.thrust()).isCloseTo(WANTED_MPS / 3.2, within(0.01));
    }

    /** In rough water it would never have turned all round. */
    @Test
    void boatThatTakesAPanoramaGoesOnTurningWhereItDriftsAmongOthers() {
        bench.vehicle.camera = CameraShot::withoutFile;
        commander.command(new TakePanorama("c3", 8));
        commander.say(new Traffic(List.of(boat("boat2", 0, 12))));
        bench.run(0.1, commander);

        bench.vehicle.eastM = 2;
        bench.run(0.5, commander);

        assertThat(bench.vehicle.thrust()).isZero();
        assertThat(bench.vehicle.rudder()).isPositive();
    }
}
