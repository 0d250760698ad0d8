package org.sami.spn.testing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Values of the boats' domain that a {@link PlayedTeam} gives: locations, and allocations of tasks to robots. */
public final class PlayedTasks {
    private PlayedTasks() {}

    /** So many locations, north of one another in degrees of WGS 84. */
    public static ListValue locations(int count) {
        List<Value> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            points.add(new GeoPoint(43.6 + i * 0.001, -79.4, 0));
        }
        return new ListValue(points);
    }

    /** One allocation that gives the tasks to the boats in turn. */
    public static ListValue allocations(Activation asked, int boats) {
        Map<Value, Value> tasks = new LinkedHashMap<>();
        asked.tasks().forEach(t -> tasks.put(t, new ProxyValue("b" + (1 + tasks.size() % boats))));
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("paths", new MapValue(Map.of(new ProxyValue("b1"), new GeoPath(List.of()))));
        fields.put("totalLengthM", new RealValue(1));
        fields.put("longestM", new RealValue(1));
        fields.put("method", new TextValue("by hand"));
        fields.put("reason", new TextValue(""));
        fields.put("unallocated", new ListValue(List.of()));
        fields.put("tasks", new MapValue(tasks));
        return new ListValue(List.of(new RecordValue("Allocation", fields)));
    }
}
