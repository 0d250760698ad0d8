package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Motion;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.link.Role;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.vehicle.LocalFrame;

/** What a boat does with what its base says of others; how it then moves among them is tested on simulated hulls (GivingWayTest of crw-sim). */
class TrafficTest {
    private static final LocalFrame FRAME = new LocalFrame(45, 10);

    private final ServerTestBench bench = new ServerTestBench();
    private ServerTestBench.Client commander;

    /** Northward at 1.5 m/s. */
    @BeforeEach
    void driveNorth() {
        commander = bench.commander();
        bench.vehicle.speedMps = 1.5;
        commander.command(new UploadWaypoints(
                "c1", "l1", List.of(new Waypoint(FRAME.latDeg(0, 100), FRAME.lonDeg(0, 100), 1.5))));
        commander.command(new StartWaypoints("c2", "l1", 0));
        bench.run(1, commander);
    }

    private static NearbyBoat boat(String id, double eastM, double northM, long ageMs) {
        return new NearbyBoat(
                id, FRAME.latDeg(eastM, northM), FRAME.lonDeg(eastM, northM), 0, 0, BoatMode.STOPPED, ageMs);
    }

    private static Traffic traffic(NearbyBoat... boats) {
        return new Traffic(List.of(boats));
    }

    private boolean isGivingWay() {
        return bench.vehicle.thrust() <= 0 || Math.abs(bench.vehicle.rudder()) > 0.3; // else it drives straight on
    }

    @Test
    void welcomeSaysThatTheBoatTakesTraffic() {
        assertThat(commander.all(Welcome.class)).allMatch(Welcome::takesTraffic);
    }

    @Test
    void boatGivesWayToOneThatLiesRightAhead() {
        assertThat(isGivingWay()).isFalse();

        commander.say(traffic(boat("boat2", 0, 5, 0)));
        bench.run(0.2, commander);

        assertThat(isGivingWay()).isTrue();
        commander.say(traffic(boat("boat2", 0, 5, 0)));
        bench.run(1, commander);
        assertThat(commander.all(Telemetry.class))
                .extracting(Telemetry::givesWayTo)
                .startsWith("")
                .contains("boat2");
    }

    @Test
    void boatOffItsStationThatHasNoRoomDrivesBackWithinHalfASecondOnceThereIsRoom() {
        commander.command(new HoldPosition("c3"));
        bench.vehicle.speedMps = 0;
        bench.vehicle.northM = -2;
        commander.say(traffic(boat("boat2", 3, -0.9, 0), boat("boat3", -3, -0.9, 0)));
        bench.run(0.3, commander);
        assertThat(bench.vehicle.thrust()).isZero();

        commander.say(traffic(boat("boat2", 15, 0, 0), boat("boat3", -16, 0, 0)));
        bench.run(0.5, commander);

        assertThat(bench.vehicle.thrust()).isPositive();
    }

    @Test
    void boatWhoseStationIsTakenLiesStillBesideItUntilItIsFree() {
        commander.command(new HoldPosition("c3"));
        bench.vehicle.speedMps = 0;
        bench.vehicle.eastM = -3.8;
        commander.say(traffic(boat("boat2", 0.2, 0, 0)));
        bench.run(1, commander);
        assertThat(bench.vehicle.thrust()).isZero();
        assertThat(bench.vehicle.rudder()).isZero();

        bench.run(4, commander); // nothing is said of boats that lie still
        commander.say(traffic(boat("boat3", -15, 0, 0)));
        bench.run(1, commander);
        assertThat(bench.vehicle.rudder()).isZero();

        commander.say(traffic(boat("boat2", 0, 15, 0)));
        bench.run(1, commander);

        assertThat(bench.vehicle.rudder()).as("it turns to its station").isPositive();
    }

    @Test
    void boatThatMayLieFarFromItsStationLiesThereAlsoWhereThatIsTaken() {
        ServerTestBench wide = new ServerTestBench(config -> config.holdRadiusM(12));
        ServerTestBench.Client client = wide.commander();
        client.command(new HoldPosition("c1"));
        wide.vehicle.eastM = -10;
        client.say(traffic(boat("boat2", 0.2, 0, 0)));
        wide.run(1, client);
        assertThat(wide.vehicle.rudder()).isZero();
        assertThat(wide.vehicle.thrust()).isZero();

        wide.vehicle.eastM = -13;
        wide.run(1, client);

        assertThat(wide.vehicle.rudder()).as("it turns to its station").isPositive();
    }

    @ParameterizedTest
    @CsvSource({"-0.9, 1", "0.9, -1"})
    void boatGoesAsideWhereNothingThatItIsNotToEnterLies(double edgeEastM, double rudder) {
        commander.say(new Traffic(List.of(boat("boat2", 0, 8, 0)), Optional.of(edge(edgeEastM))));
        bench.run(0.2, commander);

        assertThat(Math.signum(bench.vehicle.rudder())).isEqualTo(rudder);
    }

    @Test
    void boatThatGoesAnotherWayForgetsWhatItWasNotToEnter() {
        commander.say(new Traffic(List.of(boat("boat2", 0, 8, 0)), Optional.of(edge(0.9))));
        commander.command(new StartWaypoints("c3", "l1", 0));
        bench.run(0.2, commander);

        assertThat(bench.vehicle.rudder()).as("to starboard").isPositive();
    }

    /** An edge from south to north; what lies beyond it from the middle is not to be entered. */
    private static NoGoEdges edge(double eastM) {
        double fromNorthM = eastM > 0 ? -30 : 30;
        return new NoGoEdges(0.6, List.of(edge(eastM, fromNorthM, -fromNorthM)));
    }

    private static NoGoEdge edge(double eastM, double fromNorthM, double toNorthM) {
        return new NoGoEdge(
                FRAME.latDeg(eastM, fromNorthM),
                FRAME.lonDeg(eastM, fromNorthM),
                FRAME.latDeg(eastM, toNorthM),
                FRAME.lonDeg(eastM, toNorthM));
    }

    /** It keeps 5 m off, as far as its line does, and errors or a current have brought it nearer, or inside. */
    @ParameterizedTest
    @CsvSource({"3", "7", "9"})
    void boatThatCameNearerToAnEdgeThanItsLineGoesStraightOffIt(double eastM) {
        NoGoEdges edges = new NoGoEdges(5, List.of(edge(6, -30, 30)));
        bench.vehicle.eastM = eastM;
        bench.vehicle.northM = 5;
        bench.vehicle.speedMps = 0;
        bench.vehicle.headingRad = -Math.PI / 2;

        commander.say(new Traffic(List.of(boat("boat2", 20, 20, 0)), Optional.of(edges)));
        bench.run(0.2, commander);

        assertThat(bench.vehicle.thrust()).isPositive();
        assertThat(bench.vehicle.rudder()).as("westward it goes on").isCloseTo(0, within(0.1));
    }

    @Test
    void boatThatWaitsHeadsAgainstTheCurrentThatCarriesItAside() {
        bench.vehicle.speedMps = 0;
        waitInCurrent();
        assertThat(bench.vehicle.rudder())
                .as("to port, where the current comes from")
                .isLessThan(-0.5);

        bench.vehicle.headingRad = -Math.PI / 2;
        waitInCurrent();

        assertThat(bench.vehicle.rudder()).isCloseTo(0, within(0.1));
        assertThat(bench.vehicle.thrust()).as("as much as the current takes").isGreaterThan(0.3 / 3.2);
    }

    /** Among boats that leave it no way, 20 s long carried eastward at 0.5 m/s, as they are. */
    private void waitInCurrent() {
        for (int i = 0; i < 40; i++) {
            bench.vehicle.eastM += bench.vehicle.headingRad == 0 ? 0.25 : 0;
            double eastM = bench.vehicle.eastM;
            commander.say(traffic(
                    boat("boat2", eastM, 3.4, 0),
                    boat("boat3", eastM - 3.4, 0, 0),
                    boat("boat4", eastM + 3.4, 0, 0),
                    boat("boat5", eastM, -3.4, 0)));
            bench.run(0.5, commander);
        }
    }

    @Test
    void whatIsOldIsForgotten() {
        commander.say(traffic(boat("boat2", 0, 5, 0)));
        bench.run(3.3, commander);
        assertThat(isGivingWay()).isTrue();

        bench.run(0.4, commander);

        assertThat(isGivingWay()).isFalse();
    }

    @Test
    void whatWasOldWhenItWasSentCountsNot() {
        commander.say(traffic(boat("boat2", 0, 5, 3500)));
        bench.run(0.2, commander);

        assertThat(isGivingWay()).isFalse();
    }

    @Test
    void theNewestOfABoatCountsInWhateverOrderItComes() {
        commander.say(traffic(boat("boat2", 0, 60, 100)));
        commander.say(traffic(boat("boat2", 0, 5, 900)));
        bench.run(0.2, commander);

        assertThat(isGivingWay()).isFalse();
    }

    @Test
    void onlyTheCommanderIsBelieved() {
        ServerTestBench.Client observer = bench.client(Role.OBSERVER, 1);

        observer.say(traffic(boat("boat2", 0, 5, 0)));
        bench.run(0.2, commander, observer);

        assertThat(isGivingWay()).isFalse();
    }

    @Test
    void boatIsNotInItsOwnWay() {
        commander.say(traffic(boat("boat1", 0, 5, 0)));
        bench.run(0.2, commander);

        assertThat(isGivingWay()).isFalse();
    }

    /** The vehicle stays where it is, and says that it is fast. */
    @Test
    void boatThatMovesOtherwiseThanOthersExpectTellsTheCommanderFiveTimesASecond() {
        ServerTestBench.Client observer = bench.client(Role.OBSERVER, 1);
        assertThat(commander.all(Motion.class)).isEmpty();

        commander.say(traffic(boat("boat2", 10, 0, 0)));
        bench.run(2, commander, observer);

        assertThat(commander.all(Motion.class)).hasSizeBetween(9, 11).allSatisfy(motion -> {
            assertThat(motion.latDeg()).isEqualTo(bench.vehicle.latDeg());
            assertThat(motion.mode()).isEqualTo(BoatMode.PATH);
            assertThat(motion.speedMps()).isEqualTo(1.5);
        });
        assertThat(observer.all(Motion.class)).isEmpty();
    }

    @Test
    void boatThatGoesStraightOnTellsTheCommanderOnceASecondAndAtOnceWhenItTurns() {
        commander.say(traffic(boat("boat2", 10, 0, 0)));
        goStraightOn(2);
        int before = commander.all(Motion.class).size();
        bench.vehicle.headingRad += 0.1;
        goStraightOn(0.2);

        assertThat(before).isBetween(2, 3);
        assertThat(commander.all(Motion.class)).hasSizeGreaterThan(before);
    }

    private void goStraightOn(double seconds) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            bench.vehicle.northM += 0.15;
            bench.run(0.1, commander);
        }
    }

    @Test
    void boatFarFromOthersOrAtRestTellsNothingMore() {
        commander.say(traffic(boat("boat2", 30, 0, 0)));
        bench.run(1, commander);
        commander.command(new HoldPosition("c3"));
        bench.vehicle.speedMps = 0;
        commander.say(traffic(boat("boat2", 10, 0, 0)));
        bench.run(1, commander);

        assertThat(commander.all(Motion.class)).isEmpty();
    }
}
