package org.sami.mavlink.param;

import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamValue;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Reads all parameters of a vehicle: asks for all at once, and then one by one for those that did not come. Used by one thread.
 *
 * <p>Source: the parameter protocol of MAVLink's documentation.
 */
final class ParameterRead {
    private static final long QUIET_MS = 1_000;
    private static final int AT_ONCE = 10;
    private static final int TRIES = 8;

    private final VehicleId vehicle;
    private final Consumer<Object> send;
    private final TreeMap<String, Double> values = new TreeMap<>();
    private final TreeSet<Integer> missing = new TreeSet<>();
    private Optional<Integer> count = Optional.empty();
    private Optional<String> failure = Optional.empty();
    private int tries;
    private long heardMs;

    ParameterRead(VehicleId vehicle, Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.send = Objects.requireNonNull(send, "send");
    }

    void begin(long nowMs) {
        askForAll(nowMs);
    }

    private void askForAll(long nowMs) {
        tries++;
        heardMs = nowMs;
        send.accept(ParamRequestList.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .build());
    }

    /** Takes a value; one that was asked for by its name has no place among all and changes nothing. */
    void take(ParamValue value, long nowMs) {
        int all = value.paramCount();
        if (isOver() || all == 0 || value.paramIndex() >= all) {
            return;
        }
        if (count.isEmpty()) {
            count = Optional.of(all);
            IntStream.range(0, all).forEach(missing::add);
        }
        if (missing.remove(value.paramIndex())) {
            values.put(value.paramId(), (double) value.paramValue());
            heardMs = nowMs;
            tries = 0;
        }
    }

    void tick(long nowMs) {
        if (isOver() || nowMs < heardMs + QUIET_MS) {
            return;
        }
        if (tries >= TRIES) {
            failure = Optional.of("vehicle " + vehicle + " does not send its parameters"
                    + count.map(all -> ": " + values.size() + " of " + all + " came")
                            .orElse(""));
        } else if (count.isEmpty()) {
            askForAll(nowMs);
        } else {
            tries++;
            heardMs = nowMs;
            missing.stream().limit(AT_ONCE).forEach(this::ask);
        }
    }

    private void ask(int index) {
        send.accept(ParamRequestRead.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .paramId("")
                .paramIndex(index)
                .build());
    }

    boolean isOver() {
        return failure.isPresent() || (count.isPresent() && missing.isEmpty());
    }

    Optional<String> failure() {
        return failure;
    }

    /** The values by their names. */
    SortedMap<String, Double> values() {
        return values;
    }
}
