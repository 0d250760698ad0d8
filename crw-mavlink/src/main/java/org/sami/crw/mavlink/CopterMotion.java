package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * The ways in which an autopilot moves a copter: all flights are missions in AUTO, which begin with a take-off where it is on the ground; a stop in the air is
 * mode BRAKE, in which it stays where it is. Motors are turned off on the ground only. By hand it is flown with its own radio control. For the gateway's
 * thread.
 *
 * <p>Source: ArduPilot's copters; they are armed in GUIDED, take off in AUTO once the mission is started (command 300), and refuse to be disarmed in the air.
 */
final class CopterMotion extends VehicleMotion {
    static final String BRAKE = "BRAKE";

    /** Higher than this over where it was armed, in metres, it is in the air; on the ground a barometer is off by less. */
    static final double GROUND_M = 0.5;

    private static final int MISSION_START = 300;

    private static final double HOME_SPEED_MPS = 8;
    private static final int MOST_READS = 30; // a vehicle refuses them while another sends it a mission
    private static final long READ_AGAIN_MS = 1_000;

    private final Runnable homeRead;
    private Optional<Waypoint> home = Optional.empty(); // where it was last with its motors off
    private int reads; // of its home
    private long readAgainMs = Long.MIN_VALUE;
    private boolean isReading;
    private Optional<Integer> onceUp = Optional.empty(); // the item to go on at after the take-off
    private int takeOffItem;

    /**
     * The motion of a copter of which nothing was heard before.
     *
     * @param homeRead called when its home is known from what it holds
     */
    CopterMotion(MavlinkBase base, VehicleSnapshot first, Executor thread, Runnable homeRead) {
        super(base, first, thread);
        this.homeRead = homeRead;
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

    /** In the air it stays where it is; on the ground its motors are turned off. */
    @Override
    void stopBy(VehiclePilot.Order order) {
        onceUp = Optional.empty();
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
        VehiclePilot.Ordered brake = new VehiclePilot.Ordered(BRAKE, true);
        order.commandUntilAnswered(
                () -> base.setMode(id, BRAKE),
                () -> order.await(brake::isSo, "come into mode " + BRAKE, () -> order.done(brake)));
    }

    /** As a stop: on the ground it has no place to keep. */
    @Override
    void hold(Consumer<Optional<String>> ended) {
        stop(ended);
    }

    /** Nothing: who wants to fly it by hand uses its radio control. */
    @Override
    void steer(double thrust, double rudder) {}

    @Override
    void follow(VehiclePilot.Order order, Leg leg) {
        setsOffBy(order);
        onceUp = Optional.empty();
        if (isAirborne(vehicle())) {
            leg.item().ifPresentOrElse(item -> goTo(order, item, leg, () -> fly(order, leg)), () -> fly(order, leg));
        } else if (leg.takeOff().isPresent()) {
            takeOff(order, leg.takeOff().get(), leg);
        } else {
            order.fail("vehicle " + id + " is on the ground, and what it holds of its path begins in the air");
        }
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

    private void takeOff(VehiclePilot.Order order, int item, Leg leg) {
        takeOffItem = item;
        Runnable start =
                () -> order.command(base.command(id, VehicleCommand.of(MISSION_START, "start its mission")), () -> {
                    onceUp = leg.item();
                    flies(order, leg);
                });
        Runnable arm = () -> order.arm(() -> order.await(
                VehicleSnapshot::armed, "arm", () -> goTo(order, item, leg, () -> order.mode(AUTO, true, start))));
        order.mode(GUIDED, vehicle().armed(), arm);
    }

    private static void flies(VehiclePilot.Order order, Leg leg) {
        leg.started().run();
        order.done(new VehiclePilot.Ordered(AUTO, true, leg.lands()));
    }

    /** After a take-off it goes on at the item to which it was sent. */
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
        boolean isUp = vehicle.currentItem().filter(item -> item > takeOffItem).isPresent();
        if (onceUp.isPresent() && isUp && vehicle.mode().equals(AUTO) && isOrdered()) {
            int item = onceUp.get();
            onceUp = Optional.empty();
            if (vehicle.currentItem().orElseThrow() < item) {
                Results.when(base.command(id, VehicleCommand.setCurrentItem(item)), thread(), taken -> {}, why -> {});
            }
        }
        return other;
    }

    @Override
    void release() {
        super.release();
        onceUp = Optional.empty();
    }
}
