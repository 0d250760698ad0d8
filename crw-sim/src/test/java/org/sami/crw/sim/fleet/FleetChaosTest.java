package org.sami.crw.sim.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.Stop;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.link.PipeConfig;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** Everything at once, in any order: commands, withdrawals, cut links, hands, fleet stops, empty batteries. */
@Tag("long")
class FleetChaosTest {
    private static final List<Priority> PRIORITIES = List.of(Priority.values());
    private static final List<LostLinkAction> ACTIONS = List.of(LostLinkAction.values());

    private VirtualClock clock = new VirtualClock();
    private final Map<String, String> fates = new LinkedHashMap<>();

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1})
    void everyCommandHasOneFateAndTheBoatEndsAtRest(double loss) {
        for (long seed = 0; seed < 30; seed++) {
            fates.clear();
            clock = new VirtualClock();
            SplittableRandom random = new SplittableRandom(seed);
            SimulatedBoat boat = boat(seed, random, loss);
            for (int i = 0; i < 60; i++) {
                disturb(boat, random, i);
                clock.runUntil(clock.nowMs() + (random.nextBoolean() ? random.nextLong(400) : random.nextLong(20_000)));
            }

            calm(boat);
            clock.runUntil(clock.nowMs() + 600_000);
            assertThat(boat.proxy().commands().current()).as("seed %d", seed).isEmpty();
            assertThat(boat.proxy().commands().waiting()).isEmpty();
            assertThat(fates).as("seed %d", seed).isNotEmpty().doesNotContainValue("open");
            assertThat(boat.hull().speedMps()).as("seed %d", seed).isZero();
            assertThat(boat.server().mode()).isIn(BoatMode.STOPPED, BoatMode.HOLD);
            assertThat(boat.executed()).extracting(ExecutedCommand::commandId).doesNotHaveDuplicates();
        }
    }

    private SimulatedBoat boat(long seed, SplittableRandom random, double loss) {
        LostLinkAction action = ACTIONS.get(random.nextInt(ACTIONS.size()));
        FleetConfig config = FleetConfig.DEFAULT
                .withPipe(new PipeConfig(20, 30, loss))
                .withServer(server -> server.lostLinkAction(action));
        SimulatedFleet fleet = new SimulatedFleet(clock, seed, 1, 45.4, 10.9, id -> new Fates(), config);
        fleet.start();
        return fleet.boats().get(0);
    }

    private void disturb(SimulatedBoat boat, SplittableRandom random, int number) {
        BoatProxy proxy = boat.proxy();
        switch (random.nextInt(12)) {
            case 0, 1, 2, 3 -> submit(proxy, random, "c" + number);
            case 4 -> proxy.commands().withdraw(random.nextLong(1, 5)).forEach(command -> end(command, "taken back"));
            case 5, 6 -> cut(boat, random.nextBoolean(), random.nextBoolean());
            case 7 -> cut(boat, false, false);
            case 8 -> proxy.teleoperate(random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            case 9 -> proxy.release();
            case 10 -> fleetStop(proxy, random.nextBoolean());
            default -> boat.hull().setBatteryPercent(100);
        }
    }

    private void submit(BoatProxy proxy, SplittableRandom random, String id) {
        long mission = random.nextLong(1, 5);
        Priority priority = PRIORITIES.get(random.nextInt(4));
        boolean block = random.nextInt(5) == 0;
        fates.put(id, "open");
        if (random.nextInt(6) == 0) {
            proxy.commands().submit(new Stop(id, mission, 1, priority, block));
        } else {
            List<GeoPoint> points = random.doubles(random.nextInt(4), 45.4, 45.4005)
                    .mapToObj(latDeg -> GeoPoint.of(latDeg, 10.9))
                    .toList();
            FollowPath path = FollowPath.of(id, mission, 1, points, priority);
            proxy.commands().submit(block ? path.blocking() : path);
        }
    }

    private static void cut(SimulatedBoat boat, boolean up, boolean down) {
        boat.toBoat().setCut(up);
        boat.toBase().setCut(down);
    }

    private static void fleetStop(BoatProxy proxy, boolean stop) {
        if (stop) {
            proxy.fleetStop();
        } else {
            proxy.fleetRelease();
        }
    }

    /** Ends all disturbances; what may run then gets done, and what a block kept waiting after that block's mission. */
    private void calm(SimulatedBoat boat) {
        cut(boat, false, false);
        boat.proxy().release();
        for (long mission = 1; mission <= 4; mission++) {
            int minutesAtRest = 0; // a boat may rest for a moment before it does what a lost message held back
            for (int minutes = 0; minutes < 50 && minutesAtRest < 5; minutes++) {
                boat.hull().setBatteryPercent(100);
                releaseIfStopped(boat.proxy());
                clock.runUntil(clock.nowMs() + 60_000);
                minutesAtRest = isAtRest(boat) ? minutesAtRest + 1 : 0;
            }
            assertThat(boat.proxy().commands().current())
                    .as(boat.proxy().explain().text())
                    .isEmpty();
            assertThat(boat.hull().speedMps()).isZero();
            boat.proxy().commands().withdraw(mission).forEach(command -> end(command, "taken back"));
        }
    }

    /** A release that was dropped with its link is ordered again. */
    private static void releaseIfStopped(BoatProxy proxy) {
        if (!proxy.stop().equals(StopLatch.NONE)) {
            proxy.fleetRelease();
        }
    }

    private static boolean isAtRest(SimulatedBoat boat) {
        return boat.proxy().commands().current().isEmpty() && boat.hull().speedMps() == 0;
    }

    private void end(BoatCommand command, String fate) {
        assertThat(fates.put(command.commandId(), fate)).as(command.commandId()).isEqualTo("open");
    }

    private final class Fates implements Consumer<FleetEvent> {
        @Override
        public void accept(FleetEvent event) {
            if (event instanceof FleetEvent.CommandCompleted done) {
                onCompleted(done.command());
            } else if (event instanceof FleetEvent.CommandFailed failed) {
                onFailed(failed.command(), failed.reason());
            } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
                onWithdrawn(withdrawn.command(), withdrawn.why());
            }
        }

        private void onCompleted(BoatCommand command) {
            end(command, "completed");
        }

        private void onFailed(BoatCommand command, String reason) {
            end(command, "failed: " + reason);
        }

        private void onWithdrawn(BoatCommand command, Withdrawal why) {
            end(command, why.name());
        }
    }
}
