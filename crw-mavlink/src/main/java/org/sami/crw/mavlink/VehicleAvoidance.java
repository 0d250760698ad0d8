package org.sami.crw.mavlink;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Whether a vehicle's autopilot gets out of the way of others by itself, which may work against how the base steers it around them. For the gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code OA_TYPE} (0: it plans no way around obstacles), {@code AVOID_ENABLE} (bits: 1 fence, 2 proximity sensor, 4 beacons) and
 * {@code PRX1_TYPE} (0: it has no proximity sensor). Bit 2 is set as delivered, and means nothing without such a sensor.
 */
final class VehicleAvoidance {
    private static final String PLANS = "OA_TYPE";
    private static final String AVOIDS = "AVOID_ENABLE";
    private static final String SENSOR = "PRX1_TYPE";
    private static final int BY_SENSOR = 2;

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private final Consumer<String> alarm;
    private final Map<String, Long> values = new HashMap<>();
    private int reads;

    /**
     * Nothing is read yet.
     *
     * @param alarm takes what the operator should know
     */
    VehicleAvoidance(MavlinkBase base, VehicleId id, Executor thread, Consumer<String> alarm) {
        this.base = base;
        this.id = id;
        this.thread = thread;
        this.alarm = alarm;
    }

    /** A base is there: reads the parameters, and says where the vehicle avoids others by itself. A parameter that it does not have counts as 0. */
    void read() {
        values.clear();
        read(++reads, List.of(PLANS, AVOIDS, SENSOR));
    }

    private void read(int number, List<String> names) {
        if (number != reads) {
            return; // read anew meanwhile
        }
        if (names.isEmpty()) {
            conflict(values).ifPresent(text -> alarm.accept("mav" + id + " " + text));
            return;
        }
        List<String> rest = names.subList(1, names.size());
        Results.when(
                base.parameter(id, names.get(0)),
                thread,
                value -> {
                    values.put(names.get(0), Math.round(value));
                    read(number, rest);
                },
                why -> read(number, rest));
    }

    /** What these parameters have the vehicle do against the base's steering, as the rest of a sentence about it; empty where nothing. */
    static Optional<String> conflict(Map<String, Long> values) {
        long plans = values.getOrDefault(PLANS, 0L);
        long sensor = values.getOrDefault(SENSOR, 0L);
        if (plans != 0) {
            return Optional.of("plans ways around obstacles by itself (" + PLANS + " " + plans
                    + "): it may leave its path, and turn against the base where it gives way; with " + PLANS
                    + " 0 only the base steers it around others");
        }
        if ((values.getOrDefault(AVOIDS, 0L) & BY_SENSOR) != 0 && sensor != 0) {
            return Optional.of("stops and backs off from what its proximity sensor sees (" + AVOIDS + " "
                    + values.get(AVOIDS) + ", " + SENSOR + " " + sensor
                    + "): it may do so against the base where it gives way; without " + BY_SENSOR + " in " + AVOIDS
                    + " only the base steers it around others");
        }
        return Optional.empty();
    }
}
