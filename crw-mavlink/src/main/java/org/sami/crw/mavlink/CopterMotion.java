package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.CommandPlace;
import org.sami.mavlink.command.CommandVerdict;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * The ways in which an autopilot moves a copter: all flights are missions in AUTO, which begin with a take-off where it is on the ground. To go on in the midst
 * of one it first climbs straight up in GUIDED, from the ground or from where it is too low ({@link CopterClimb}), as the part that it holds may have no take-off. A
 * stop in the air is mode BRAKE, in which it stays where it is. Motors are turned off on the ground only. By hand it is flown with its own radio control. For
 * the gateway's thread.
 *
 * <p>Source: ArduPilot's copters; they are armed in GUIDED, take off in AUTO once the mission is started (command 300), in GUIDED by command 22, which they refuse in
 * the air, and refuse to be disarmed in the air.
 */
final class CopterMotion extends VehicleMotion {
    static final String BRAKE = "BRAKE";

    /** Higher than this over where it was armed, in metres, it is in the air; on the ground a barometer is off by less. */
    static final double GROUND_M = 0.5;

    private static final VehiclePilot.Ordered BRAKES = new VehiclePilot.Ordered(BRAKE, true);
    private static final int MISSION_START = 300;

    private static final long LIFT_OFF_MS = 10_000; // after it has accepted to take off: its motors spin up first
    private static final long LOOK_MS = 4_000; // whether it takes off though it says that it does not

    private static final double HOME_SPEED_MPS = 8;
    private static final int MOST_READS = 30; // a vehicle refuses them while another sends it a mission
    private static final long READ_AGAIN_MS = 1_000;

    private final Runnable homeRead;
    private final Consumer<String> alarm;
    private Optional<Waypoint> home = Optional.empty(); // where it was last with its motors off
    private int reads; // of its home
    private long readAgainMs = Long.MIN_VALUE;
    private boolean isReading;
    private Optional<CopterClimb> climb = Optional.empty(); // after which it goes on along its mission
    private boolean isUp; // its mission is looked at before it goes on along it

    /**
     * The motion of a copter of which nothing was heard before.
     *
     * @param homeRead called when its home is known from what it holds
     * @param alarm receives, in words for the operator, why it does not go on after a take-off
     */
    CopterMotion(MavlinkBase base, VehicleSnapshot first, Executor thread, Runnable homeRead, Consumer<String> alarm) {
        super(base, first, thread);
        this.homeRead = homeRead;
        this.alarm = alarm;
    }

    @Override
    boolean flies() {
        return true;
    }

    /** Where its motors were off last: there it was armed. Of one that is met with its motors on, the home that it holds. */
    @Override
    Optional<Waypoint> home() {
        return home;
    }

    /** The autopilot keeps its home as item 0 of its mission, whatever item 0 was sent. */
    private void readHome() {
        isReading = true;
        reads++;
        Results.when(
                base.held(id, HeldKind.MISSION),
                thread(),
                items -> {
                    isReading = false;
                    reads = MOST_READS;
                    Optional<Waypoint> held = items.stream()
                            .findFirst()
                            .filter(item -> item.latDeg() != 0 || item.lonDeg() != 0)
                            .map(item -> new Waypoint(item.latDeg(), item.lonDeg(), HOME_SPEED_MPS));
                    if (home.isEmpty() && held.isPresent()) {
                        home = held;
                        homeRead.run();
                    }
                },
                why -> isReading = false);
    }

    /** Whether it is in the air. */
    static boolean isAirborne(VehicleSnapshot vehicle) {
        return vehicle.armed()
                && vehicle.position()
                        .map(VehiclePosition::heightM)
                        .filter(metres -> metres > GROUND_M)
                        .isPresent();
    }

    /** Never: in GUIDED it climbs, and goes on along its mission then. */
    @Override
    boolean isGuided() {
        return false;
    }

    /** In the air it stays where it is; on the ground its motors are turned off. */
    @Override
    void stopBy(VehiclePilot.Order order) {
        if (isAirborne(vehicle())) {
            brake(order);
        } else {
            order.commandUntilAnswered(
                    () -> base.command(id, VehicleCommand.disarm()),
                    () -> order.await(
                            now -> !now.armed(),
                            "turn its motors off",
                            () -> order.done(new VehiclePilot.Ordered(vehicle().mode(), false))),
                    () -> brake(order)); // it has just taken off
        }
    }

    private void brake(VehiclePilot.Order order) {
        brake(order, () -> order.done(BRAKES));
    }

    private void brake(VehiclePilot.Order order, Runnable next) {
        order.expect(BRAKE);
        order.commandUntilAnswered(
                () -> base.setMode(id, BRAKE), () -> order.await(BRAKES::isSo, "come into mode " + BRAKE, next));
    }

    /** As a stop, but nobody is overruled: on the ground it has no place to keep. */
    @Override
    void hold(Consumer<Optional<String>> ended) {
        stopUnlessTaken(ended);
    }

    /** Nothing: who wants to fly it by hand uses its radio control. */
    @Override
    void steer(double thrust, double rudder, Consumer<String> failed) {}

    @Override
    void follow(VehiclePilot.Order order, Leg leg) {
        setsOffBy(order);
        if (isAirborne(vehicle())) {
            leg.climb()
                    .filter(climb -> leg.item().isPresent() && isLower(climb.leastM())) // else it flies there already
                    .ifPresentOrElse(climb -> climbOn(order, climb), () -> flyAlong(order, leg));
        } else if (leg.takeOff().isPresent()) {
            takeOff(order, leg.takeOff().get(), leg);
        } else if (leg.climb().isPresent()) {
            takeOff(order, leg.climb().get());
        } else {
            order.fail("vehicle " + id + " is on the ground, and its path does not begin with a take-off");
        }
    }

    private boolean isLower(double thanM) {
        return vehicle()
                .position()
                .filter(at -> CopterClimb.isBelow(at.heightM(), thanM))
                .isPresent();
    }

    private void flyAlong(VehiclePilot.Order order, Leg leg) {
        leg.item().ifPresentOrElse(item -> goTo(order, item, leg, () -> fly(order, leg)), () -> fly(order, leg));
    }

    private void goTo(VehiclePilot.Order order, int item, Leg leg, Runnable next) {
        order.command(base.command(id, VehicleCommand.setCurrentItem(item)), () -> {
            leg.goesThere().run();
            next.run();
        });
    }

    private void fly(VehiclePilot.Order order, Leg leg) {
        order.mode(
                AUTO,
                true,
                () -> order.command(
                        base.command(id, VehicleCommand.setSpeed(leg.speedMps())), () -> flies(order, leg)));
    }

    /** By the take-off of its mission, and along that from its first waypoint. */
    private void takeOff(VehiclePilot.Order order, int item, Leg leg) {
        Runnable start = () -> order.command(
                base.command(id, VehicleCommand.of(MISSION_START, "start its mission")), () -> flies(order, leg));
        armed(order, () -> goTo(order, item, leg, () -> order.mode(AUTO, true, start)));
    }

    private void armed(VehiclePilot.Order order, Runnable next) {
        order.mode(GUIDED, vehicle().armed(), () -> order.arm(() -> order.await(VehicleSnapshot::armed, "arm", next)));
    }

    /** By itself, to go on in the midst of its mission once it is up. */
    private void takeOff(VehiclePilot.Order order, Climb climb) {
        armed(order, () -> {
            long armedMs = vehicle().heardMs(); // its height counts from where it is armed
            Predicate<VehicleSnapshot> hasLiftedOff = now -> isAirborne(now)
                    && now.position().filter(at -> at.heardMs() > armedMs).isPresent();
            Runnable climbs = () -> climbs(order, climb);
            order.command(
                    base.command(id, VehicleCommand.takeOff(climb.toM())),
                    () -> order.await(hasLiftedOff, "take off", LIFT_OFF_MS, climbs, why -> endTakeOff(order, why)),
                    // one that climbs refuses to take off, such as where its first answer was lost
                    refusal -> order.await(hasLiftedOff, "take off", LOOK_MS, climbs, why -> refused(order, refusal)));
        });
    }

    private void refused(VehiclePilot.Order order, CommandOutcome outcome) {
        if (outcome.verdict() == CommandVerdict.UNANSWERED) {
            endTakeOff(order, outcome.inWords());
        } else {
            order.fail(outcome.inWords());
        }
    }

    /** It may take off yet: its motors are turned off, or it stays where it is in the air. One that is silent, or in a mode of somebody else, gets no order. */
    private void endTakeOff(VehiclePilot.Order order, String why) {
        if (!isHeard() || !vehicle().mode().equals(GUIDED)) {
            order.failAsItIs(why);
            return;
        }
        order.commandUntilAnswered(
                () -> base.command(id, VehicleCommand.disarm()),
                () -> order.failAsItIs(why),
                () -> brake(order, () -> order.failAsItIs(why + "; it stays where it is in the air")));
    }

    /** Straight up from where it is. */
    private void climbOn(VehiclePilot.Order order, Climb climb) {
        order.mode(GUIDED, true, () -> {
            VehiclePosition at = vehicle().position().orElseThrow();
            CommandPlace above = new CommandPlace(at.latDeg(), at.lonDeg(), climb.toM());
            order.command(
                    base.command(id, VehicleCommand.reposition(above, Optional.empty())), () -> climbs(order, climb));
        });
    }

    private void climbs(VehiclePilot.Order order, Climb ordered) {
        climb = Optional.of(new CopterClimb(ordered, vehicle(), nowMs()));
        isUp = false;
        ordered.begins().run();
        order.done(new VehiclePilot.Ordered(GUIDED, true));
    }

    private void look(CopterClimb now, VehicleSnapshot vehicle, long atMs) {
        now.saw(vehicle, isHeard(), atMs);
        if (isHeard() && now.isUp()) {
            isUp = true;
            now.ordered().mission().whenHeld(why -> {
                if (climb.filter(still -> still == now)
                        .isPresent()) { // else it got another order, or is somebody else's
                    why.ifPresentOrElse(this::stays, () -> goOn(now.ordered()));
                }
            });
        } else {
            now.fault(atMs).ifPresent(this::stays);
        }
    }

    private void goOn(Climb ended) {
        climb = Optional.empty();
        VehiclePilot.Order order = pilot.change(
                why -> why.filter(words -> !words.equals(VehiclePilot.VOID) && !words.equals(VehiclePilot.TAKEN))
                        .ifPresent(this::stays));
        setsOffBy(order);
        Leg leg = ended.then().get();
        flyAlong(order, leg);
    }

    private void stays(String why) {
        forgetNext();
        alarm.accept("vehicle " + id + " has taken off, and does not go on along its path: " + why);
        boolean isOurs = vehicle().mode().equals(GUIDED) || vehicle().mode().equals(AUTO);
        if (isHeard() && isOurs) {
            stopUnlessTaken(ended -> {});
        }
    }

    @Override
    void forgetNext() {
        climb = Optional.empty();
    }

    private static void flies(VehiclePilot.Order order, Leg leg) {
        leg.started().run();
        order.done(new VehiclePilot.Ordered(AUTO, true, leg.lands()));
    }

    /** Once it is up it goes on along its mission. */
    @Override
    boolean reported(VehicleSnapshot vehicle, long atMs) {
        boolean other = super.reported(vehicle, atMs);
        if (!vehicle.armed() && vehicle.located()) {
            home = vehicle.position()
                    .map(at -> new Waypoint(at.latDeg(), at.lonDeg(), HOME_SPEED_MPS))
                    .or(() -> home);
        } else if (vehicle.armed() && home.isEmpty() && !isReading && reads < MOST_READS && atMs >= readAgainMs) {
            readAgainMs = atMs + READ_AGAIN_MS;
            readHome();
        }
        climb.filter(now -> !isUp).ifPresent(now -> look(now, vehicle, atMs));
        return other;
    }
}
