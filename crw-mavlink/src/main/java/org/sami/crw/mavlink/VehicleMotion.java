package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.CommandPlace;
import org.sami.mavlink.command.GuidedCourse;
import org.sami.mavlink.command.HandControl;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * The ways in which an autopilot moves a boat, each as an order of its own: the later one makes the earlier one void. Those of a copter differ ({@link
 * CopterMotion}). For the gateway's thread.
 */
class VehicleMotion {
    static final String AUTO = "AUTO";
    static final String GUIDED = "GUIDED";
    static final String LOITER = "LOITER";
    static final String HOLD = "HOLD";

    private static final String MANUAL = "MANUAL";
    private static final long MS = 1_000; // in a second

    final MavlinkBase base;
    final VehicleId id;
    final VehiclePilot pilot;
    private final Executor thread;
    private Optional<Hand> hand = Optional.empty();
    private Optional<VehiclePilot.Order> settingOff = Optional.empty(); // along a mission; the last one
    private Optional<VehiclePilot.Order> stopping = Optional.empty(); // the last one
    private boolean isAside;
    private long nowMs;

    /** Sticks, and when they were set. */
    private record Hand(double thrust, double rudder, long atMs) {}

    /** Brings a mission to the vehicle and calls back: with nothing once it is there, or with the reason why it is not. */
    interface Delivery {
        void whenHeld(Consumer<Optional<String>> then);
    }

    /**
     * How it begins to follow a mission.
     *
     * @param item from which it goes on; empty for a vehicle that follows the mission already, which is not disturbed
     * @param takeOff the item with which a copter on the ground begins; empty for boats, and where it goes on further along the mission
     * @param climb with which a copter that is on the ground, or too low, goes on further along the mission; empty for boats
     * @param lands whether the mission ends with a landing
     * @param speedMps of the leg under way
     * @param goesThere called when the vehicle has taken the item, before it reports progress from there on
     * @param started called when it follows it
     */
    record Leg(
            Optional<Integer> item,
            Optional<Integer> takeOff,
            Optional<Climb> climb,
            boolean lands,
            double speedMps,
            Runnable goesThere,
            Runnable started) {}

    /**
     * How a copter comes to the height from which it goes on along its mission. It climbs by itself, in GUIDED, as the mission that it holds may have no take-off.
     *
     * @param toM the height to which it climbs, metres over its home
     * @param leastM lower than this, in metres over its home, one in the air climbs first
     * @param begins called when it climbs
     * @param mission brings the mission to it once it is up
     * @param then how it follows the mission then; asked once that is there
     */
    record Climb(double toM, double leastM, Runnable begins, Delivery mission, Supplier<Leg> then) {}

    VehicleMotion(MavlinkBase base, VehicleSnapshot first, Executor thread) {
        this.base = base;
        this.id = first.id();
        this.thread = thread;
        pilot = new VehiclePilot(base, first, thread);
    }

    VehicleSnapshot vehicle() {
        return pilot.vehicle();
    }

    /** Whether it is in a state into which it was ordered here. */
    boolean isOrdered() {
        return pilot.ordered().isPresent();
    }

    /** Whether it drives along its mission, or stands at the end of it. */
    boolean isInAuto() {
        return vehicle().armed() && vehicle().mode().equals(AUTO);
    }

    /** Whether an order is being carried out. */
    boolean isBusy() {
        return pilot.isBusy();
    }

    /** Whether it is being ordered to follow a mission that it holds; it may drive before its heartbeat says so. */
    boolean isSettingOff() {
        return settingOff.filter(order -> !order.isVoid()).isPresent();
    }

    /** Whether it is being stopped; it may still report that it drives. */
    boolean isStopping() {
        return stopping.filter(order -> !order.isVoid()).isPresent();
    }

    /** The time of what the vehicle has reported last. */
    final long nowMs() {
        return nowMs;
    }

    /** Whether it was heard just now, so that an order reaches it at once. */
    boolean isHeard() {
        return nowMs - vehicle().heardMs() <= VehicleLinks.HEARD_MS;
    }

    /** Whether it is steered around others, or is about to be, in place of what it was ordered to do. */
    boolean isAside() {
        return isAside;
    }

    /** Whether it was sent to a single place. */
    boolean isGuided() {
        return !isAside
                && pilot.ordered().filter(state -> state.mode().equals(GUIDED)).isPresent();
    }

    /** The order with which it sets off along a mission. */
    final void setsOffBy(VehiclePilot.Order order) {
        settingOff = Optional.of(order);
    }

    /** The gateway's thread. */
    final Executor thread() {
        return thread;
    }

    /** Where it returns to, at the speed at which it does; empty where an autopilot does not say it. */
    Optional<Waypoint> home() {
        return Optional.empty();
    }

    /** Whether it flies. */
    boolean flies() {
        return false;
    }

    /** Forgets the ordered state: a change of mode or arming is no longer taken for somebody else's. */
    void release() {
        forgetNext();
        pilot.release();
        hand = Optional.empty();
        isAside = false;
    }

    /** The vehicle reports itself. Whether somebody else has changed its state; it is released then. */
    boolean reported(VehicleSnapshot vehicle, long atMs) {
        nowMs = atMs;
        boolean other = pilot.reported(vehicle, atMs);
        if (other || pilot.isStartedByOthers()) {
            release();
        }
        return other;
    }

    /** Whether somebody else has just started it while nothing is ordered. */
    boolean isStartedByOthers() {
        return pilot.isStartedByOthers();
    }

    void tick(long atMs) {
        nowMs = atMs;
        hand.ifPresent(sticks -> {
            if (atMs - sticks.atMs > LinkDefaults.TELEOPERATION_STOP_MS) {
                stop(why -> {});
            } else if (!pilot.isBusy()) {
                base.steer(id, new HandControl(sticks.thrust, 0, 0, sticks.rudder));
            }
        });
    }

    /** What it was to go on with by itself, after what it was ordered to do, is not done any longer. */
    void forgetNext() {}

    /** Nobody commands it any longer: of the order that is being carried out, and what was to follow it, no more is done. A stop goes on. */
    final void abandon() {
        forgetNext();
        boolean mayArm = hand.isPresent() && isHeard() && !vehicle().armed(); // an order to arm may be under way
        hand = Optional.empty();
        if (mayArm) {
            stop(why -> {});
        } else if (!isStopping()) {
            pilot.giveUp();
        }
    }

    /** Every order but {@link #stepAside} and {@link #goOn} ends what is done to give way. */
    VehiclePilot.Order begin(Consumer<Optional<String>> ended) {
        forgetNext();
        isAside = false;
        return pilot.begin(ended);
    }

    /** Stops it, and asks for that until the vehicle answers, whoever has it meanwhile. A stop of a vehicle that is being stopped ends with the one under way. */
    final void stop(Consumer<Optional<String>> ended) {
        stopUnlessTaken(ended);
        stopping.ifPresent(VehiclePilot.Order::insist);
    }

    /** The same, as long as nobody else takes it. */
    final void stopUnlessTaken(Consumer<Optional<String>> ended) {
        if (isStopping()) {
            stopping.orElseThrow().tellAlso(ended);
            return;
        }
        hand = Optional.empty();
        VehiclePilot.Order order = begin(ended);
        stopping = Optional.of(order);
        stopBy(order);
    }

    /** Motors off at once, and mode HOLD, so that it lies still if somebody arms it again. */
    void stopBy(VehiclePilot.Order order) {
        order.commandUntilAnswered(
                () -> base.command(id, VehicleCommand.disarmAtOnce()),
                () -> order.commandUntilAnswered(
                        () -> base.setMode(id, HOLD), // even if it was last seen in it: that may be older than an order
                        () -> order.mode(HOLD, false, () -> order.done(new VehiclePilot.Ordered(HOLD, false)))));
    }

    /** Keeps its place. */
    void hold(Consumer<Optional<String>> ended) {
        byItself(ended)
                .ifPresent(order -> arm(
                        order,
                        () -> order.modeAnew(LOITER, true, () -> order.done(new VehiclePilot.Ordered(LOITER, true)))));
    }

    /** Arms it in a mode in which it lies still: one that was disarmed on its way would go on with that way. */
    private void arm(VehiclePilot.Order order, Runnable next) {
        if (vehicle().armed()
                || vehicle().mode().equals(HOLD)
                || vehicle().mode().equals(MANUAL)) {
            order.arm(next);
        } else {
            order.modeAnew(HOLD, false, () -> order.arm(next));
        }
    }

    /** Begins an order that needs a position; without one it is refused, and the order before stays in force. */
    private Optional<VehiclePilot.Order> byItself(Consumer<Optional<String>> ended) {
        if (!vehicle().located()) {
            ended.accept(Optional.of("vehicle " + id + " cannot drive by itself: its filter has no position"));
            return Optional.empty();
        }
        hand = Optional.empty();
        return Optional.of(begin(ended));
    }

    /** Goes to a single place and keeps it. */
    void guide(Waypoint place, double speedMps, Runnable started, Consumer<Optional<String>> ended) {
        byItself(ended)
                .ifPresent(order -> arm(
                        order,
                        () -> order.mode(
                                GUIDED,
                                true,
                                () -> order.command(
                                        base.command(id, reposition(place)), () -> goes(order, speedMps, started)))));
    }

    private void goes(VehiclePilot.Order order, double speedMps, Runnable started) {
        order.command(base.command(id, VehicleCommand.setSpeed(speedMps)), () -> {
            started.run();
            order.done(new VehiclePilot.Ordered(GUIDED, true));
        });
    }

    /** Follows the mission that it then holds; {@code leg} is asked once that is there. */
    void follow(Delivery mission, Supplier<Leg> leg, Consumer<Optional<String>> ended) {
        byItself(ended)
                .ifPresent(order -> mission.whenHeld(why -> {
                    if (why.isPresent()) {
                        order.fail(why.get());
                    } else if (!order.isVoid()) {
                        follow(order, leg.get());
                    }
                }));
    }

    void follow(VehiclePilot.Order order, Leg leg) {
        setsOffBy(order);
        Runnable drive = () -> arm(
                order,
                () -> order.mode(
                        AUTO,
                        true,
                        () -> order.command(base.command(id, VehicleCommand.setSpeed(leg.speedMps)), () -> {
                            leg.started.run();
                            order.done(new VehiclePilot.Ordered(AUTO, true));
                        })));
        leg.item.ifPresentOrElse(
                item -> order.command(base.command(id, VehicleCommand.setCurrentItem(item)), () -> {
                    leg.goesThere.run();
                    drive.run();
                }),
                drive);
    }

    /** Changes the speed of the leg under way. */
    void speed(double mps) {
        Results.when(base.command(id, VehicleCommand.setSpeed(mps)), thread, (CommandOutcome outcome) -> {}, why -> {});
    }

    /** Leaves what it was ordered to do, to be steered around others with {@link #steerAside}. Where the vehicle refuses, it goes on as ordered. */
    void stepAside(Consumer<Optional<String>> ended) {
        VehiclePilot.Order order = pilot.change(why -> {
            isAside &= why.isEmpty() || why.get().equals(VehiclePilot.VOID);
            ended.accept(why);
        });
        isAside = true;
        order.mode(GUIDED, true, () -> order.done(new VehiclePilot.Ordered(GUIDED, true)));
    }

    /** Heading and speed while it is aside. They hold for at most 3 s. */
    void steerAside(GuidedCourse course) {
        base.guide(id, course);
    }

    /** Goes on along its mission after it was aside; where the vehicle refuses, it stays aside. */
    void goOn(Leg leg, Consumer<Optional<String>> ended) {
        VehiclePilot.Order order = pilot.change(ended);
        follow(order, new Leg(leg.item, leg.takeOff, leg.climb, leg.lands, leg.speedMps, leg.goesThere, () -> {
            isAside = false;
            leg.started.run();
        }));
    }

    /** Goes on to its single place after it was aside; where the vehicle refuses, it stays aside. */
    void goOn(Waypoint place, double speedMps, Consumer<Optional<String>> ended) {
        VehiclePilot.Order order = pilot.change(ended);
        order.command(base.command(id, reposition(place)), () -> goes(order, speedMps, () -> isAside = false));
    }

    private static VehicleCommand reposition(Waypoint place) {
        return VehicleCommand.reposition(
                new CommandPlace(place.latDeg(), place.lonDeg(), 0),
                Optional.empty()); // with a speed ArduPilot refuses it
    }

    /** Moves to a place near the end of its path, where it keeps its place; where the vehicle refuses, it stays as it was. */
    void move(Waypoint place, Consumer<Optional<String>> ended) {
        VehiclePilot.Order order = pilot.change(ended);
        order.mode(
                GUIDED,
                true,
                () -> order.command(
                        base.command(id, reposition(place)), () -> goes(order, place.speedMps(), () -> {})));
    }

    /**
     * Sticks of a person, -1 to 1; in force until the next ones, at most for the dead man's time.
     *
     * @param failed receives why the vehicle is not driven so, in words: it refuses, or has not begun as it is to stand again
     */
    void steer(double thrust, double rudder, Consumer<String> failed) {
        boolean begins = hand.isEmpty();
        hand = Optional.of(new Hand(thrust, rudder, nowMs));
        if (begins) {
            long beganMs = nowMs;
            VehiclePilot.Order order = begin(why -> why.ifPresent(words -> {
                hand = Optional.empty();
                if (!words.equals(VehiclePilot.VOID)) {
                    failed.accept(words);
                } else if (nowMs - beganMs >= LinkDefaults.TELEOPERATION_STOP_MS) {
                    failed.accept("vehicle " + id + " has not come into mode " + MANUAL + ", armed, within "
                            + (nowMs - beganMs) / MS + " s");
                }
            }));
            order.mode(
                    MANUAL,
                    vehicle().armed(),
                    () -> order.arm(() -> order.await(
                            VehicleSnapshot::armed, "arm", () -> order.done(new VehiclePilot.Ordered(MANUAL, true)))));
        }
    }
}
