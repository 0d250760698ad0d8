package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.mavlink.FaultCase.Fault;
import org.sami.crw.mavlink.FaultCase.Phase;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.protocol.Priority;

/** The course of one case: a base brings a vehicle into a phase of a path, a fault comes and ends, and the path is driven to its end. */
final class FaultCourse implements AutoCloseable {
    static final long TOLD_MS = 4_000;

    private final FaultCase what;
    private final FaultyVehicle boat;
    private final Path folder;
    private GatewayWorld world;
    private Optional<String> list = Optional.empty(); // that the vehicle was given before its base died

    /**
     * A base that does not know the vehicle.
     *
     * @param folder where it keeps what it knows of vehicles
     */
    FaultCourse(FaultCase what, FaultyVehicle boat, Path folder) {
        this.what = what;
        this.boat = boat;
        this.folder = folder;
        world = new GatewayWorld(folder);
    }

    /** Nothing is done twice, nothing moves unasked, and the operator hears of the fault. */
    void run() throws Exception {
        try {
            go();
        } catch (AssertionError e) {
            throw new AssertionError(what + ": " + e.getMessage() + "\nsaid: " + String.join("\n", world.alarms), e);
        }
    }

    private void go() throws Exception {
        Fault fault = what.fault();
        Phase phase = what.phase();
        reach(phase);
        if (!phase.moves()) {
            boat.markPlace();
        }
        boolean wasArmed = boat.armings() > 0;

        long beganMs = ProcessClock.ms();
        begin(fault, phase);

        if (what.isTold()) {
            isTold(fault, beganMs);
        }
        if (!phase.moves()) {
            boat.assertLiesStill();
        }
        int before = boat.armings();
        assertThat(before).isLessThanOrEqualTo(1);
        boat.letOn();
        end(fault);
        if (phase == Phase.BY_HAND) {
            comesToRest(fault);
            return;
        }
        world.untilReady(boat.name());
        if (phase == Phase.STOPPED) {
            untilStopped();
            world.tell(boat.name(), BoatProxy::fleetRelease);
        }
        if (fault == Fault.REBOOT && phase.isConnected()) {
            assertThat(boat.isArmed()).isFalse();
            Await.until(
                    "it says where it is", GatewayWorld.WAIT_S, this::isSeenAgain); // before, a yes would be too early
            Await.until("it is ready", GatewayWorld.WAIT_S, boat::isReady);
            world.tell(boat.name(), BoatProxy::confirmRestart);
        }
        if (fault == Fault.BASE_KILLED || !phase.isOrdered()) {
            list.ifPresent(
                    held -> world.tell(boat.name(), proxy -> proxy.commands().knownList(held)));
            submit();
        }
        completes();
        assertThat(boat.armings()).isEqualTo(what.isArmedAgain() ? before + 1 : 1);
        assertThat(boat.uploads()).isLessThanOrEqualTo(phase.isConnected() && !wasArmed ? 2 : 1);
        boat.assertVisitedOnceInOrder();
    }

    private void reach(Phase phase) {
        if (phase == Phase.BEFORE_CONNECTING) {
            return;
        }
        if (phase == Phase.CONNECTING) {
            boat.holdAt(phase);
            world.connect(boat.address());
            untilHeld("the vehicle is being connected");
            return;
        }
        world.connect(boat.address());
        world.untilReady(boat.name());
        boat.holdAt(phase);
        switch (phase) {
            case UPLOAD_BEGUN, UPLOAD_HALF, UPLOADED, STARTING -> {
                submit();
                untilHeld("the mission is on its way, or it is ordered to set off");
                if (phase == Phase.UPLOADED) {
                    Await.until("it has the mission", GatewayWorld.WAIT_S, () -> boat.uploads() == 1);
                }
            }
            case UNDER_WAY -> setsOff();
            case HALF_WAY -> {
                setsOff();
                Await.until(
                        "a point is visited",
                        GatewayWorld.WAIT_S,
                        () -> boat.visits() == 1
                                && world.has(FleetEvent.Progressed.class, news -> news.visited() == 1));
            }
            case BY_HAND -> {
                boat.markPlace();
                world.tell(boat.name(), proxy -> proxy.teleoperate(0.5, 0));
                Await.until("it moves", GatewayWorld.WAIT_S, () -> boat.movedM() > 1);
            }
            case STOPPED -> {
                setsOff();
                world.tell(boat.name(), BoatProxy::fleetStop);
                untilStopped();
            }
            default -> throw new IllegalStateException("no such phase: " + phase);
        }
    }

    private void untilHeld(String words) {
        Await.until(words, GatewayWorld.WAIT_S, boat::isHeld);
    }

    private void setsOff() {
        submit();
        world.until(
                "it is under way", boat.name(), proxy -> proxy.status().mode().equals(Optional.of(BoatMode.PATH)));
    }

    private void untilStopped() {
        world.until(
                "it is stopped", boat.name(), proxy -> proxy.status().mode().equals(Optional.of(BoatMode.FLEET_STOP)));
    }

    private void submit() {
        world.tell(
                boat.name(),
                proxy -> proxy.commands().submit(FollowPath.of("path", 1, 1, boat.path(), Priority.MEDIUM)));
    }

    private void begin(Fault fault, Phase phase) throws Exception {
        if (fault == Fault.BASE_KILLED) {
            boat.deaf(true);
            list = phase.isConnected()
                    ? world.ask(boat.name(), proxy -> proxy.commands().heldListId())
                    : Optional.empty();
            world.close();
        } else {
            boat.begin(fault);
            if (phase == Phase.BEFORE_CONNECTING) {
                world.connect(boat.address());
            }
        }
    }

    private void isTold(Fault fault, long beganMs) {
        if (fault == Fault.REBOOT) {
            Await.until(
                    "the restart is told",
                    GatewayWorld.WAIT_S,
                    () -> world.has(FleetEvent.Restarted.class, news -> true));
        } else {
            Await.until(
                    "the link is lost",
                    GatewayWorld.WAIT_S,
                    () -> world.has(
                            FleetEvent.LinkChanged.class, news -> news.status().link() == LinkState.LOST));
        }
        assertThat(ProcessClock.ms() - beganMs).isLessThanOrEqualTo(TOLD_MS);
    }

    private void end(Fault fault) throws Exception {
        if (fault == Fault.BASE_KILLED) {
            boat.deaf(false);
            world = new GatewayWorld(folder, "base-2");
            world.connect(boat.address());
        } else {
            boat.end(fault);
        }
    }

    /** Whether it has said where it is since its restart was told. */
    private boolean isSeenAgain() {
        return world.events.stream()
                .dropWhile(news -> !(news instanceof FleetEvent.Restarted))
                .anyMatch(FleetEvent.StatusReported.class::isInstance);
    }

    /** Nobody steers it any longer: it is stopped, or the next base is told who has it. */
    private void comesToRest(Fault fault) {
        if (fault == Fault.BASE_KILLED) {
            Await.until(
                    "the next base is told that it is driven",
                    GatewayWorld.WAIT_S,
                    () -> world.alarms.stream()
                            .anyMatch(text -> text.startsWith(boat.name() + " is taken by a pilot")));
            world.until("the next base has it in its fleet", boat.name(), proxy -> true); // the alarm comes before
            world.tell(boat.name(), BoatProxy::fleetStop);
        }
        Await.until("it is disarmed", GatewayWorld.WAIT_S, () -> !boat.isArmed());
        assertThat(boat.armings()).isEqualTo(1);
    }

    private void completes() {
        Await.until(
                "the path is completed",
                GatewayWorld.WAIT_S,
                () -> world.has(FleetEvent.CommandCompleted.class, done -> true)
                        || world.has(FleetEvent.CommandFailed.class, failed -> {
                            throw new AssertionError(failed.reason());
                        }));
    }

    @Override
    public void close() {
        world.close();
        assertThat(world.faults).isEmpty();
    }
}
