package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.link.PipeConfig;
import org.sami.spn.protocol.Priority;

class FleetLinksTest {

    private static void cut(SimulatedTestWorld world, boolean cut) {
        world.boat().toBoat().setCut(cut);
        world.boat().toBase().setCut(cut);
    }

    @Test
    void lostLinkIsShownWithinHalfASecondOfTheLimit() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.run(10);
        cut(world, true); // the last frame came at 9.12 s
        world.clock.runUntil(12_600);
        assertThat(world.proxy().status().link()).isEqualTo(LinkState.LINKED);

        world.clock.runUntil(12_700);

        assertThat(world.proxy().status().link()).isEqualTo(LinkState.LOST);
        assertThat(world.reports()).endsWith("link LOST");
        assertThat(world.proxy().explain().text()).contains("the link has been lost");
    }

    @Test
    void boatTakesInWhatHasArrivedWhenItsTickBegins() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.run(10.05);

        world.proxy().commands().submit(world.path(1, 0, 40)); // what it sends comes 20 ms later
        world.run(0.1);

        assertThat(world.boat().executed()).extracting(ExecutedCommand::timeMs).containsExactly(10_100L);
    }

    @ParameterizedTest
    @EnumSource(LostLinkAction.class)
    void pathGoesOnWhereItWasAfterALostLink(LostLinkAction action) {
        SimulatedTestWorld world =
                new SimulatedTestWorld(1, 3, FleetConfig.DEFAULT.withServer(server -> server.lostLinkAction(action)));
        world.proxy().commands().submit(world.path(1, 0, 40, 0, 80, 0, 120));
        world.run(40);
        cut(world, true);
        world.run(30);
        double northM = world.hull().northM();
        cut(world, false);
        world.run(150);

        assertThat(world.reports())
                .containsSubsequence("visited 1 of m1-boat1", "link LOST", "link LINKED", "completed m1-boat1");
        assertThat(world.reports().stream().filter(line -> line.startsWith("visited")))
                .hasSize(3);
        assertThat(world.distanceTo(0, 120)).isLessThan(5);
        long uploads = world.boat().executed().stream()
                .filter(e -> e.command() instanceof UploadWaypoints)
                .count();
        assertThat(uploads).as("the boat still held the list").isEqualTo(1);
        assertThat(northM).isGreaterThan(action == LostLinkAction.RETURN ? 0 : 40);
    }

    @Test
    void boatHoldsWhileTheLinkIsLost() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 0, 400));
        world.run(40);
        cut(world, true);
        world.run(10);

        double northM = world.hull().northM();
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.HOLD);
        assertThat(world.hull().speedMps()).isZero();
        world.run(60);
        assertThat(world.hull().northM()).isEqualTo(northM);
    }

    @Test
    void boatThatLostItsCommanderAloneIsToldToGoOn() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 0, 200));
        world.run(40);
        world.boat().toBoat().setCut(true); // telemetry still comes
        world.run(20);
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.HOLD);
        assertThat(world.proxy().status().link()).isEqualTo(LinkState.LINKED);

        world.boat().toBoat().setCut(false);
        world.run(150);

        assertThat(world.reports()).endsWith("completed m1-boat1");
    }

    @Test
    void missionWithdrawnDuringALostLinkLeavesTheBoatStoppedAfterwards() {
        SimulatedTestWorld world = new SimulatedTestWorld(
                1, 3, FleetConfig.DEFAULT.withServer(server -> server.lostLinkAction(LostLinkAction.CONTINUE)));
        world.proxy().commands().submit(world.path(1, 0, 400));
        world.run(30);
        cut(world, true);
        world.run(10);
        world.proxy().commands().withdraw(1);
        world.run(10);
        assertThat(world.hull().speedMps()).isGreaterThan(1);
        int starts = starts(world);

        cut(world, false);
        world.run(8);

        assertThat(world.hull().speedMps()).isZero();
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(starts(world)).isEqualTo(starts);
    }

    private static int starts(SimulatedTestWorld world) {
        return (int) world.boat().executed().stream()
                .filter(e -> e.command() instanceof StartWaypoints)
                .count();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.05, 0.2})
    void pathIsDrivenOverALinkThatLosesFrames(double loss) {
        for (long seed = 0; seed < 10; seed++) {
            SimulatedTestWorld world =
                    new SimulatedTestWorld(1, seed, FleetConfig.DEFAULT.withPipe(new PipeConfig(30, 40, loss)));
            world.proxy().commands().submit(world.path(1, 0, 30, 30, 30, 30, 0));
            world.run(600);

            assertThat(world.reports()).as("seed %d", seed).contains("completed m1-boat1");
            assertThat(world.distanceTo(30, 0)).isLessThan(6);
            assertThat(world.boat().executed())
                    .extracting(ExecutedCommand::commandId)
                    .doesNotHaveDuplicates();
        }
    }

    /** In one run of fifty the base gives up: all requests of a command are lost, or the link is, in each of its tries. */
    @Test
    void pathIsDrivenInAlmostEachRunOverALinkThatLosesHalfOfItsFrames() {
        int completed = 0;
        for (long seed = 0; seed < 10; seed++) {
            SimulatedTestWorld world =
                    new SimulatedTestWorld(1, seed, FleetConfig.DEFAULT.withPipe(new PipeConfig(30, 40, 0.5)));
            world.proxy().commands().submit(world.path(1, 0, 30, 30, 30, 30, 0));
            world.run(600);
            completed += world.reports().contains("completed m1-boat1") ? 1 : 0;
            assertThat(world.boat().executed())
                    .extracting(ExecutedCommand::commandId)
                    .doesNotHaveDuplicates();
        }

        assertThat(completed).isGreaterThanOrEqualTo(9);
    }

    @Test
    void framesThatTheCodecWritesAndReadsGiveTheSameRun() {
        PipeConfig lossy = new PipeConfig(30, 40, 0.1);
        Conditions field = new Conditions(1, 2, new Flow(0.2, 90), Flow.NONE, List.of());
        SimulatedTestWorld plain = new SimulatedTestWorld(
                3, 4, FleetConfig.DEFAULT.withConditions(field).withPipe(lossy));
        SimulatedTestWorld coded = new SimulatedTestWorld(
                3, 4, FleetConfig.DEFAULT.withConditions(field).withPipe(lossy.coded()));
        for (SimulatedTestWorld world : List.of(plain, coded)) {
            world.proxy().commands().submit(world.path(1, 0, 60, 40, 60, 40, 0));
            world.run(200);
            world.proxy().teleoperate(0.1, 0.3);
            world.run(5);
        }

        for (int i = 0; i < 3; i++) {
            SimulatedBoat boat = plain.fleet.boats().get(i);
            SimulatedBoat other = coded.fleet.boats().get(i);
            assertThat(boat.track()).isEqualTo(other.track());
            assertThat(boat.proxy().status()).isEqualTo(other.proxy().status());
            assertThat(boat.executed())
                    .extracting(ExecutedCommand::timeMs, ExecutedCommand::commandId)
                    .isEqualTo(other.executed().stream()
                            .map(e -> tuple(e.timeMs(), e.commandId()))
                            .toList());
        }
        assertThat(plain.reports()).contains("completed m1-boat1").isEqualTo(coded.reports());
    }

    @Test
    void linkCutAtAnyStepOfAnUploadEndsWithTheWholePathDriven() {
        SplittableRandom random = new SplittableRandom(12);
        for (int trial = 0; trial < 40; trial++) {
            SimulatedTestWorld world = new SimulatedTestWorld(1, trial, FleetConfig.DEFAULT);
            world.proxy().commands().submit(world.path("a", 1, Priority.MEDIUM, 0, 200));
            world.run(20);
            world.proxy().commands().submit(world.path("b", 1, Priority.MEDIUM, 10, 40, 20, 40));
            world.clock.runUntil(world.clock.nowMs() + random.nextLong(150));
            cut(world, true);
            world.run(random.nextInt(1, 12));
            cut(world, false);
            world.run(120);

            assertThat(world.reports()).as("trial %d", trial).contains("SUPERSEDED a", "completed b");
            assertThat(world.distanceTo(20, 40)).isLessThan(5);
        }
    }

    @Test
    void handThatDrivesTakesTheBoatUntilItIsReleased() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 0, 60));
        world.run(10);
        for (int i = 0; i < 100; i++) {
            world.proxy().teleoperate(0.4, 0.5);
            world.run(0.1);
        }
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.TELEOPERATION);
        assertThat(world.proxy().explain().text()).contains("driven by hand");
        world.run(10);
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(world.hull().speedMps()).isZero();

        world.proxy().release();
        world.run(120);

        assertThat(world.reports()).endsWith("completed m1-boat1");
    }

    @Test
    void deadmanStopsTheMotorsTwoSecondsAfterTheLastSetting() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.run(1);
        world.proxy().teleoperate(0.5, 0);
        world.run(2.0);
        assertThat(world.hull().speedMps()).isPositive();

        world.run(3.0);

        assertThat(world.hull().speedMps()).isZero();
        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void fleetStopHoldsEveryBoatUntilReleasedAndMissionsGoOn() {
        SimulatedTestWorld world = new SimulatedTestWorld(2);
        for (SimulatedBoat boat : world.fleet.boats()) {
            boat.proxy().commands().submit(world.path("m1-" + boat.id(), 1, Priority.MEDIUM, 0, 60));
        }
        world.run(15);
        world.fleet.proxies().fleetStop();
        world.run(5);

        assertThat(world.fleet.boats()).allSatisfy(boat -> {
            assertThat(boat.hull().speedMps()).isZero();
            assertThat(boat.server().mode()).isEqualTo(BoatMode.FLEET_STOP);
            assertThat(boat.proxy().explain().text()).contains("it is stopped until it is released; one command waits");
        });
        world.proxy().commands().submit(world.path("crit", 2, Priority.CRITICAL, 30, 0));
        world.run(20);
        assertThat(world.hull().speedMps()).isZero();

        world.fleet.proxies().fleetRelease();
        world.run(120);

        assertThat(world.reports()).containsSubsequence("completed crit", "completed m1-boat1");
        assertThat(world.recorders.get("boat2").lines).endsWith("completed m1-boat2");
    }

    @Test
    void fleetStopPressedWhileTheLinkIsLostReachesTheBoatLater() {
        SimulatedTestWorld world = new SimulatedTestWorld(
                1, 1, FleetConfig.DEFAULT.withServer(server -> server.lostLinkAction(LostLinkAction.CONTINUE)));
        world.proxy().commands().submit(world.path(1, 0, 300));
        world.run(20);
        cut(world, true);
        world.run(6);
        world.fleet.proxies().fleetStop();
        world.run(6);
        assertThat(world.hull().speedMps()).isGreaterThan(1);

        cut(world, false);
        world.run(6);

        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.FLEET_STOP);
        assertThat(world.hull().speedMps()).isZero();
    }

    @Test
    void fleetStopTakesUpALinkThatWasCutOnPurposeAndIsRepeatedUntilTheBoatAnswers() {
        SimulatedTestWorld world = new SimulatedTestWorld(
                1, 1, FleetConfig.DEFAULT.withServer(server -> server.lostLinkAction(LostLinkAction.CONTINUE)));
        world.proxy().commands().submit(world.path(1, 0, 300));
        world.run(20);
        world.proxy().disconnect();
        world.run(6);
        cut(world, true);
        world.fleet.proxies().fleetStop(); // this one frame is lost
        world.run(3);
        assertThat(world.hull().speedMps()).isGreaterThan(1);

        cut(world, false);
        world.run(6);

        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.FLEET_STOP);
        assertThat(world.proxy().isAwaitingFleetAnswer()).isFalse();
    }

    @Test
    void pathThatIsSentAgainAndThenWithdrawnWhileTheLinkIsLostDoesNotDriveOn() {
        SimulatedTestWorld world = drivingOnWithoutALink();

        world.proxy().commands().sendPathAgain();
        world.proxy().commands().withdraw(1);
        world.run(6);

        assertStoppedOnceTheLinkIsBack(world);
    }

    @Test
    void boatThatIsStoppedAndReleasedWhileTheLinkIsLostDoesNotDriveOnWithoutAMission() {
        SimulatedTestWorld world = drivingOnWithoutALink();

        world.fleet.proxies().fleetStop();
        world.proxy().commands().withdraw(1);
        world.fleet.proxies().fleetRelease();
        world.run(6);

        assertStoppedOnceTheLinkIsBack(world);
    }

    /** A boat on its way, which goes on along it though its link is lost. */
    private static SimulatedTestWorld drivingOnWithoutALink() {
        SimulatedTestWorld world = new SimulatedTestWorld(
                1, 1, FleetConfig.DEFAULT.withServer(server -> server.lostLinkAction(LostLinkAction.CONTINUE)));
        world.proxy().commands().submit(world.path(1, 0, 300));
        world.run(20);
        cut(world, true);
        world.run(6);
        return world;
    }

    private static void assertStoppedOnceTheLinkIsBack(SimulatedTestWorld world) {
        assertThat(world.hull().speedMps()).isGreaterThan(1);
        assertThat(world.proxy().isAtRest()).isFalse();

        cut(world, false);
        world.run(6);

        assertThat(world.boat().server().mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(world.proxy().isAtRest()).isTrue();
    }

    @Test
    void batteryClassesReachTheListenerAsTheyChange() {
        SimulatedTestWorld world = new SimulatedTestWorld(1);
        world.proxy().commands().submit(world.path(1, 0, 400));
        world.hull().setBatteryPercent(30.2);
        world.run(20);
        world.hull().setBatteryPercent(15.1);
        world.run(20);
        world.hull().recharge();
        world.run(1);

        assertThat(world.reports().stream().filter(line -> line.startsWith("battery")))
                .isEqualTo(List.of("battery NOMINAL", "battery LOW", "battery CRITICAL", "battery NOMINAL"));
    }
}
