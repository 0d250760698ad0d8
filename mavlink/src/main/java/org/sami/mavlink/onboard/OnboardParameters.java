package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.sami.mavlink.vehicle.VehicleId;

/** Answers the parameter protocol: all, one, or a new value, which is answered with the value that holds then. For one thread. */
final class OnboardParameters {
    private static final int UNNUMBERED = 0xffff; // of a value that answers a new one

    private final OnboardHost host;
    private final Consumer<Object> send;

    OnboardParameters(OnboardHost host, Consumer<Object> send) {
        this.host = host;
        this.send = send;
    }

    /** Handles a message. Gives the reason for people at the station where its request is refused. Messages of other protocols change nothing. */
    Optional<String> take(VehicleId station, Object message) {
        if (message instanceof ParamRequestList) {
            List<OnboardParameter> all = host.parameters();
            IntStream.range(0, all.size()).forEach(i -> tell(all, i, i));
        } else if (message instanceof ParamRequestRead read) {
            return read(read);
        } else if (message instanceof ParamSet set) {
            return set(station, set);
        }
        return Optional.empty();
    }

    private Optional<String> read(ParamRequestRead read) {
        List<OnboardParameter> all = host.parameters();
        int index = read.paramIndex() >= 0 ? read.paramIndex() : indexOf(all, read.paramId());
        if (index < 0 || index >= all.size()) {
            return Optional.of("no parameter " + (read.paramIndex() >= 0 ? "" + index : read.paramId()));
        }
        tell(all, index, index);
        return Optional.empty();
    }

    private Optional<String> set(VehicleId station, ParamSet set) {
        int index = indexOf(host.parameters(), set.paramId());
        if (index < 0) {
            return Optional.of("no parameter " + set.paramId());
        }
        OrderReply reply = Float.isNaN(set.paramValue()) || Float.isInfinite(set.paramValue())
                ? OrderReply.denied(set.paramId() + " is no number")
                : host.setParameter(station, set.paramId(), set.paramValue());
        tell(host.parameters(), index, UNNUMBERED);
        return reply.isAccepted() ? Optional.empty() : Optional.of(reply.words());
    }

    private static int indexOf(List<OnboardParameter> all, String name) {
        return IntStream.range(0, all.size())
                .filter(i -> all.get(i).name().equals(name))
                .findFirst()
                .orElse(-1);
    }

    private void tell(List<OnboardParameter> all, int which, int number) {
        send.accept(ParamValue.builder()
                .paramId(all.get(which).name())
                .paramValue((float) all.get(which).value())
                .paramType(MavParamType.MAV_PARAM_TYPE_REAL32)
                .paramCount(all.size())
                .paramIndex(number)
                .build());
    }
}
