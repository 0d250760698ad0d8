package org.sami.crw.operator.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

class TaskWaysTest {
    private static final TaskId FIRST = new TaskId(1, "Search 1");
    private static final TaskId SECOND = new TaskId(1, "Search 2");
    private static final TaskId THIRD = new TaskId(1, "Search 3");
    private static final GeoPoint NORTH = GeoPoint.of(45.5, 10.9);
    private static final GeoPoint SOUTH = GeoPoint.of(45.3, 10.9);

    @Test
    void anAllocationBecomesThePathOfEachRobotThroughThePlacesOfItsTasks() {
        Value allocation = allocation();

        assertThat(TaskWays.tasks(allocation)).containsExactly(FIRST, SECOND, THIRD);
        Value drawn = TaskWays.of(allocation, Map.of(FIRST, NORTH, SECOND, SOUTH, THIRD, NORTH));

        assertThat(((RecordValue) drawn).fields())
                .containsEntry("longestM", new RealValue(12))
                .containsEntry(
                        "tasks",
                        new MapValue(Map.of(
                                new ProxyValue("copter1"), new GeoPath(List.of(NORTH, NORTH)),
                                new ProxyValue("copter2"), new GeoPath(List.of(SOUTH)))));
    }

    @Test
    void withoutPlacesItStaysAsItIs() {
        assertThat(TaskWays.of(allocation(), Map.of())).isEqualTo(allocation());
        assertThat(TaskWays.tasks(NORTH)).isEmpty();
    }

    private static Value allocation() {
        Map<Value, Value> tasks = new LinkedHashMap<>();
        tasks.put(FIRST, new ProxyValue("copter1"));
        tasks.put(SECOND, new ProxyValue("copter2"));
        tasks.put(THIRD, new ProxyValue("copter1"));
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("tasks", new MapValue(tasks));
        fields.put("longestM", new RealValue(12));
        return new RecordValue("Allocation", fields);
    }
}
