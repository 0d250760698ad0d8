package org.sami.crw.event;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * A path for each boat: one option of the event Operator Path Options (appendix .2.1).
 *
 * @param paths the path of each boat that has one, without its present position
 * @param totalLengthM sum of the lengths of all paths, each from its boat's position at the time of the request
 * @param longestM length of the longest path, measured likewise
 * @param method how they were found, for people
 * @param kept how far each path keeps from what is to be avoided, where it is less, and how much longer than the shortest it is for that, for
 *     people; empty text in open water
 */
public record PathOption(Map<String, GeoPath> paths, double totalLengthM, double longestM, String method, String kept) {
    /** Name of the record type in the vocabulary. */
    public static final String TYPE = "PathOption";

    public PathOption {
        paths = Collections.unmodifiableMap(new LinkedHashMap<>(paths));
        Objects.requireNonNull(method, "method");
        Objects.requireNonNull(kept, "kept");
    }

    /** The paths alone: what an option was in vocabularies before this type. */
    public MapValue pathsValue() {
        return ProxyMaps.toValue(paths);
    }

    /** This option as a value of the vocabulary's type {@link #TYPE}. */
    public RecordValue toValue() {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("paths", pathsValue());
        fields.put("totalLengthM", new RealValue(totalLengthM));
        fields.put("longestM", new RealValue(longestM));
        fields.put("method", new TextValue(method));
        fields.put("kept", new TextValue(kept));
        return new RecordValue(TYPE, fields);
    }
}
