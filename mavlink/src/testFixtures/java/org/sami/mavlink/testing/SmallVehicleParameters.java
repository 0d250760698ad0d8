package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;

/** The parameters of a small vehicle, and how they are read and set. For one thread at a time. */
final class SmallVehicleParameters {
    /** The parameter with the kind of its camera; 0 for none. */
    static final String CAMERA = "CAM1_TYPE";

    private final SortedMap<String, Float> values;
    private final Set<String> asked = new HashSet<>();
    private final Consumer<Object> send;

    private SmallVehicleParameters(Map<String, Float> values, Consumer<Object> send) {
        this.values = new TreeMap<>(values);
        this.send = send;
    }

    static SmallVehicleParameters ofBoat(Consumer<Object> send) {
        return new SmallVehicleParameters(
                Map.ofEntries(
                        Map.entry("STAT_BOOTCNT", 41f),
                        Map.entry("FS_GCS_ENABLE", 0f),
                        Map.entry("FS_ACTION", 2f),
                        Map.entry("WP_SPEED", 1.5f),
                        Map.entry("CRUISE_SPEED", 2f),
                        Map.entry("TURN_RADIUS", 0.5f),
                        Map.entry("WP_RADIUS", 2f),
                        Map.entry("FENCE_ENABLE", 0f),
                        Map.entry("FENCE_TYPE", 6f),
                        Map.entry("FENCE_ACTION", 1f),
                        Map.entry(CAMERA, 0f)),
                send);
    }

    static SmallVehicleParameters ofCopter(Consumer<Object> send) {
        return new SmallVehicleParameters(
                Map.ofEntries(
                        Map.entry("STAT_BOOTCNT", 7f),
                        Map.entry("FS_GCS_ENABLE", 0f),
                        Map.entry("FS_OPTIONS", 16f),
                        Map.entry("WPNAV_SPEED", 800f),
                        Map.entry("FENCE_ENABLE", 0f),
                        Map.entry("FENCE_TYPE", 7f),
                        Map.entry("FENCE_ACTION", 1f),
                        Map.entry(CAMERA, 0f)),
                send);
    }

    boolean wasAsked(String name) {
        return asked.contains(name);
    }

    float value(String name) {
        return values.get(name);
    }

    void set(String name, float value) {
        values.put(name, value);
    }

    /** Sets one, and says so. */
    void change(String name, float value) {
        values.put(name, value);
        report(name);
    }

    /** Receives a message; false where it is not about parameters. */
    boolean take(Object message) {
        if (message instanceof ParamRequestRead request) {
            String name = request.paramIndex() < 0
                    ? request.paramId()
                    : List.copyOf(values.keySet()).get(request.paramIndex());
            asked.add(name);
            report(name);
        } else if (message instanceof ParamRequestList) {
            List.copyOf(values.keySet()).forEach(this::report);
        } else if (message instanceof ParamSet set) {
            values.put(set.paramId(), set.paramValue());
            report(set.paramId());
        } else {
            return false;
        }
        return true;
    }

    private void report(String name) {
        if (values.containsKey(name)) {
            send.accept(ParamValue.builder()
                    .paramId(name)
                    .paramValue(values.get(name))
                    .paramType(MavParamType.MAV_PARAM_TYPE_REAL32)
                    .paramCount(values.size())
                    .paramIndex(values.headMap(name).size())
                    .build());
        }
    }
}
