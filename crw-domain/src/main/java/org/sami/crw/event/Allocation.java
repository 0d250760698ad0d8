package org.sami.crw.event;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * Who visits what, and in which order: one option of the event Operator Allocation Options (appendix .2.1).
 *
 * @param paths the locations of each boat in the order of its visits, without its present position; a boat that has
 *     nothing to visit has an empty path
 * @param totalLengthM sum of the lengths of all paths, each from its boat's position at the time of the allocation
 * @param longestM length of the longest path, measured likewise
 * @param method how it was found, for people
 */
public record Allocation(Map<String, GeoPath> paths, double totalLengthM, double longestM, String method) {
    /** Name of the record type in the vocabulary. */
    public static final String TYPE = "Allocation";

    public Allocation {
        paths = Collections.unmodifiableMap(new LinkedHashMap<>(paths));
        Objects.requireNonNull(method, "method");
    }

    /** This allocation as a value of the vocabulary's type {@link #TYPE}. */
    public RecordValue toValue() {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("paths", ProxyMaps.toValue(paths));
        fields.put("totalLengthM", new RealValue(totalLengthM));
        fields.put("longestM", new RealValue(longestM));
        fields.put("method", new TextValue(method));
        return new RecordValue(TYPE, fields);
    }

    /**
     * Reads what {@link #toValue} writes.
     *
     * @throws IllegalArgumentException for a value of another type
     */
    public static Allocation of(Value value) {
        if (!(value instanceof RecordValue fields) || !fields.type().equals(TYPE)) {
            throw new IllegalArgumentException("Not an allocation: " + value);
        }
        return new Allocation(
                ProxyMaps.read(required(fields, "paths"), GeoPath.class),
                Numbers.real(required(fields, "totalLengthM")),
                Numbers.real(required(fields, "longestM")),
                ((TextValue) required(fields, "method")).value());
    }

    private static Value required(RecordValue fields, String name) {
        return fields.field(name)
                .orElseThrow(() -> new IllegalArgumentException("An allocation without \"" + name + "\""));
    }
}
