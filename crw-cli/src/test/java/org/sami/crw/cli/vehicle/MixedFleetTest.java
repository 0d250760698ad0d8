package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.mavlink.testing.SmallCopter;
import org.sami.spn.value.GeoPoint;

/** A simulated boat over TCP and one that speaks MAVLink, in one plan. */
@Tag("long")
@Timeout(900)
class MixedFleetTest {
    @TempDir
    private Path folder;

    private static final GeoPoint PIER = GeoPoint.of(45.7, 10.72);

    @Test
    void onePlanRunsOnBoatsOfBothKinds() throws Exception {
        SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(1);
        try (SmallBoat vehicle = new SmallBoat(9, PIER.latDeg(), PIER.lonDeg() + 0.0002, 3)) {
            String both = simulated.launch("anna", PIER) + "," + vehicle.address() + "/9";

            CommandResult ran = CommandResult.crw("run", "clv", "--connect", both, "--area", "30", "--locations", "4");

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out())
                    .contains("locations visited   4 of 4")
                    .containsPattern("anna +\\d+ m")
                    .containsPattern("mav9 +\\d+ m");
            assertThat(vehicle.movedM()).isGreaterThan(3);
        } finally {
            simulated.close();
        }
    }

    /** The autopilot of the vehicle has no failsafe, as delivered; the boat of ours holds its place. */
    @Test
    void sessionSaysWhichBoatsDoSomethingElseWithoutALinkThanItWishesAndSetsThem() throws Exception {
        SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(1);
        try (SmallBoat vehicle = new SmallBoat(9, PIER.latDeg(), PIER.lonDeg() + 0.0002, 3)) {
            String both = simulated.launch("anna", PIER) + "," + vehicle.address() + "/9";
            Path script = Files.writeString(
                    folder.resolve("script"), "wait boats 2 within 120\nwait 2\nlost-link\nlost-link set\nquit\n");

            CommandResult led = CommandResult.crw(
                    "session", "--lost-link", "hold", "--connect", both, "--script", script.toString());

            assertThat(led.exitCode()).as(led.out() + led.err()).isZero();
            assertThat(led.out())
                    .contains("wished: without a link a boat holds its place")
                    .contains("anna holds its place")
                    .contains("mav9 goes on with its path, else holds its place (FS_GCS_ENABLE 0): set it")
                    .contains("mav9 is set, as it has confirmed")
                    .contains("mav9 holds its place (FS_GCS_ENABLE 1, FS_ACTION 6)");
            assertThat(vehicle.parameter("FS_ACTION")).isEqualTo(6);
        } finally {
            simulated.close();
        }
    }

    @Test
    void runSetsWhatItsBoatsDoWithoutALink() throws Exception {
        try (SmallBoat vehicle = new SmallBoat(9, PIER.latDeg(), PIER.lonDeg(), 5)) {
            CommandResult ran = CommandResult.crw(
                    "run",
                    "clv",
                    "--lost-link",
                    "return",
                    "--connect",
                    vehicle.address() + "/9",
                    "--area",
                    "30",
                    "--locations",
                    "2");

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out() + ran.err()).contains("without a link mav9 returns to its home, as it has confirmed");
            assertThat(ran.out()).contains("   " + vehicle.address() + "/9");
            assertThat(ran.out() + ran.err()).contains("2 locations for one boat are more than one each");
            assertThat(vehicle.parameter("FS_GCS_ENABLE")).isEqualTo(1);
            assertThat(vehicle.parameter("FS_ACTION")).isEqualTo(3);
        }
        assertThat(CommandResult.crw("run", "clv", "--lost-link", "return").err())
                .contains("--lost-link is of boats that are connected");
    }

    @Test
    void runByBothLinksOfAVehicleIsARunOfOneBoat() throws Exception {
        try (SmallBoat vehicle = new SmallBoat(9, PIER.latDeg(), PIER.lonDeg(), 5)) {
            String both = vehicle.address() + "," + vehicle.secondAddress();

            CommandResult ran = CommandResult.crw("run", "clv", "--connect", both, "--area", "30", "--locations", "2");

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out())
                    .contains("locations visited   2 of 2")
                    .contains("mav9 is heard on ")
                    .containsOnlyOnce("  mav9    ");
            assertThat(vehicle.armings()).isEqualTo(1);
        }
    }

    /** A copter searches; boats of both kinds are there to sample what is seen, and a copter of others sees nothing that MAVLink tells. */
    @Test
    void teamOfACopterAndBoatsOfBothKindsComesToItsEnd() throws Exception {
        Conditions withThermometer =
                new Conditions(0, 0, Flow.NONE, Flow.NONE, List.of(SensorSetting.parse("temperature")));
        SimulatedBoatsOnTcp simulated = new SimulatedBoatsOnTcp(1, withThermometer);
        try (SmallCopter copter = new SmallCopter(6, PIER.latDeg() - 0.0003, PIER.lonDeg(), 5);
                SmallBoat vehicle = new SmallBoat(9, PIER.latDeg(), PIER.lonDeg() + 0.0002, 3)) {
            String all = simulated.launch("anna", PIER) + "," + copter.address() + "/6," + vehicle.address() + "/9";

            CommandResult ran = CommandResult.crw(
                    "run", "--domain", "team", "scout-and-sample", "--connect", all, "--area", "60", "--for", "600");

            assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
            assertThat(ran.out())
                    .contains("outcome             ended")
                    .contains("The area is searched")
                    .containsPattern("mav6 +\\d+ m");
            assertThat(copter.highestM()).isGreaterThan(30);
            assertThat(copter.isArmed()).isFalse();
            assertThat(copter.fell()).isFalse();
        } finally {
            simulated.close();
        }
    }
}
