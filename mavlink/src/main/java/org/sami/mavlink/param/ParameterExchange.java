package org.sami.mavlink.param;

import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.mavlink.vehicle.VehicleId;

/** Reads one parameter, or sets it: the vehicle answers both with the value that it holds then. Used by one thread. */
final class ParameterExchange {
    private static final long ANSWER_MS = 1_000;
    private static final int TRIES = 5;

    private final VehicleId vehicle;
    private final String name;
    private final Optional<Double> wanted;
    private final Consumer<Object> send;
    private Optional<Double> value = Optional.empty();
    private Optional<String> failure = Optional.empty();
    private int tries;
    private long sentMs;

    /** An exchange that is not begun yet; it sets the parameter where a value is {@code wanted}. */
    ParameterExchange(VehicleId vehicle, String name, Optional<Double> wanted, Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.name = Objects.requireNonNull(name, "name");
        this.wanted = wanted.map(exact -> (double) exact.floatValue()); // as exactly as messages carry it
        this.send = Objects.requireNonNull(send, "send");
    }

    void begin(long nowMs) {
        tries++;
        sentMs = nowMs;
        send.accept(wanted.<Object>map(set -> ParamSet.builder()
                        .targetSystem(vehicle.system())
                        .targetComponent(vehicle.component())
                        .paramId(name)
                        .paramValue(set.floatValue())
                        .paramType(MavParamType.MAV_PARAM_TYPE_REAL32)
                        .build())
                .orElseGet(() -> ParamRequestRead.builder()
                        .targetSystem(vehicle.system())
                        .targetComponent(vehicle.component())
                        .paramId(name)
                        .paramIndex(-1)
                        .build()));
    }

    void take(ParamValue answer, long nowMs) {
        if (isOver() || !answer.paramId().equals(name)) {
            return;
        }
        double holds = answer.paramValue();
        if (wanted.filter(set -> set != holds).isEmpty()) {
            value = Optional.of(holds);
        } else if (tries == TRIES) {
            failure = Optional.of("vehicle " + vehicle + " keeps " + name + " at " + holds + " when it is set to "
                    + wanted.orElseThrow());
        } // otherwise it may be an answer to an earlier question: the tick asks again
    }

    void tick(long nowMs) {
        if (isOver() || nowMs < sentMs + ANSWER_MS) {
            return;
        }
        if (tries == TRIES) {
            failure = Optional.of("vehicle " + vehicle + " has no parameter " + name + ", or does not answer");
        } else {
            begin(nowMs);
        }
    }

    boolean isOver() {
        return value.isPresent() || failure.isPresent();
    }

    Optional<Double> value() {
        return value;
    }

    Optional<String> failure() {
        return failure;
    }
}
