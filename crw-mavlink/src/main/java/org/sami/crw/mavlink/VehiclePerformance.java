package org.sami.crw.mavlink;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.BoatPerformance;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * How far, how fast and how narrowly a vehicle drives: speed and turns by its parameters, the range as {@link VehicleConsumption} has counted it. For the
 * gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code WP_SPEED} (0: {@code CRUISE_SPEED} counts), {@code TURN_RADIUS}, and {@code WP_RADIUS}, within which it cuts corners. A copter
 * turns on the spot; its speed is {@code WPNAV_SPEED} in cm/s.
 */
final class VehiclePerformance {
    private static final String SPEED = "WP_SPEED";
    private static final String CRUISE = "CRUISE_SPEED";
    private static final String TURN = "TURN_RADIUS";
    private static final String CORNER = "WP_RADIUS";
    private static final List<String> NAMES = List.of(SPEED, CRUISE, TURN, CORNER);
    private static final String FLIGHT_SPEED = "WPNAV_SPEED";
    private static final double CM = 100;
    private static final double USUAL_RADIUS_M = 2; // ArduPilot's, where it is not read
    private static final double LEAST_MPS = 0.05; // this and the next two are what the link carries
    private static final double MOST_MPS = 50;
    private static final double MOST_RADIUS_M = 1000;
    private static final double LEAST_METRES_PER_PERCENT = 0.01;
    private static final double NEWS = 0.05; // part by which the range changes before it is said again

    private final MavlinkBase base;
    private final VehicleId id;
    private final boolean flies;
    private final Executor thread;
    private final VehicleConsumption consumption;
    private final Consumer<VehicleConsumption> keep;
    private final Map<String, Double> values = new HashMap<>();
    private OptionalDouble saidRange = OptionalDouble.empty();
    private int reads;
    private int open;

    /**
     * Begins to read the parameters.
     *
     * @param consumption what was counted of the vehicle before
     * @param keep takes what is counted, each time it has changed
     */
    VehiclePerformance(
            MavlinkBase base,
            VehicleId id,
            boolean flies,
            Executor thread,
            VehicleConsumption consumption,
            Consumer<VehicleConsumption> keep) {
        this.base = base;
        this.id = id;
        this.flies = flies;
        this.thread = thread;
        this.consumption = consumption;
        this.keep = keep;
        read();
    }

    /** Reads the parameters again: the autopilot has started again. */
    void read() {
        int number = ++reads;
        List<String> names = flies ? List.of(FLIGHT_SPEED) : NAMES;
        open = names.size();
        for (String name : names) {
            Results.when(
                    base.parameter(id, name),
                    thread,
                    value -> answered(number, () -> values.put(name, value)),
                    why -> answered(number, () -> values.remove(name))); // a firmware without it
        }
    }

    private void answered(int number, Runnable change) {
        if (number == reads) {
            change.run();
            open--;
        }
    }

    /** Whether all parameters are read, or the vehicle has not answered for them. A base needs the speed before it compares a list. */
    boolean isRead() {
        return open == 0;
    }

    /** The vehicle reports itself. Returns whether {@link #now} has changed so much that it is to be said again. */
    boolean reported(VehicleSnapshot vehicle) {
        if (!consumption.reported(vehicle)) {
            return false;
        }
        keep.accept(consumption);
        OptionalDouble range = range();
        double change = Math.abs(range.orElse(0) - saidRange.orElse(0));
        boolean news = range.isPresent() && change > NEWS * saidRange.orElse(0);
        saidRange = news ? range : saidRange;
        return news;
    }

    /** Within which distance of a waypoint it has reached it, in metres. */
    double waypointRadiusM() {
        return number(CORNER).orElse(USUAL_RADIUS_M);
    }

    private OptionalDouble range() {
        return consumption.metresPerPercent().stream()
                .filter(metres -> metres >= LEAST_METRES_PER_PERCENT)
                .findFirst();
    }

    /** What is known now. */
    BoatPerformance now() {
        if (flies) {
            return new BoatPerformance(range(), speed(FLIGHT_SPEED, CM), OptionalDouble.of(0));
        }
        OptionalDouble speed = speed(SPEED, 1);
        return new BoatPerformance(range(), speed.isPresent() ? speed : speed(CRUISE, 1), radius());
    }

    private OptionalDouble speed(String name, double unitsPerMetre) {
        return number(name).stream()
                .map(value -> value / unitsPerMetre)
                .filter(mps -> mps >= LEAST_MPS && mps <= MOST_MPS)
                .findFirst();
    }

    private OptionalDouble radius() {
        OptionalDouble turn = number(TURN);
        OptionalDouble corner = number(CORNER);
        return turn.isEmpty() && corner.isEmpty()
                ? OptionalDouble.empty()
                : OptionalDouble.of(Math.min(MOST_RADIUS_M, Math.max(0, Math.max(turn.orElse(0), corner.orElse(0)))));
    }

    private OptionalDouble number(String name) {
        Double value = values.get(name);
        return value == null || !Double.isFinite(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }
}
