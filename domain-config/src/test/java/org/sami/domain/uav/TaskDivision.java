package org.sami.domain.uav;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** A service: divides tasks among the aircraft in turn, or gives each to the nearest. */
final class TaskDivision implements ActivationHandler {
    private final Map<String, SimulatedUav> fleet;

    TaskDivision(Map<String, SimulatedUav> fleet) {
        this.fleet = fleet;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<String> known = context.query(view -> view.proxies()).stream()
                .filter(fleet::containsKey)
                .toList();
        Map<Value, Value> inTurn = new LinkedHashMap<>();
        Map<Value, Value> nearest = new LinkedHashMap<>();
        List<TaskId> tasks = activation.tasks();
        for (int i = 0; i < tasks.size(); i++) {
            GeoPoint where = location(context, tasks.get(i));
            inTurn.put(tasks.get(i), new ProxyValue(known.get(i % known.size())));
            String near = known.stream()
                    .min(Comparator.comparingDouble(name -> fleet.get(name).distanceM(where)))
                    .orElseThrow();
            nearest.put(tasks.get(i), new ProxyValue(near));
        }
        List<Value> options = new ArrayList<>(List.of(option(inTurn, "in turn"), option(nearest, "the nearest")));
        context.post(new Input.Received(Occurrence.answer(
                "AllocationsComputed", activation, List.of(), tasks, Map.of("allocations", new ListValue(options)))));
    }

    private static GeoPoint location(HandlerContext context, TaskId task) {
        return (GeoPoint) context.query(view -> view.task(task)).orElseThrow().get("location");
    }

    private static RecordValue option(Map<Value, Value> tasks, String method) {
        return new RecordValue(
                "Allocation",
                Map.of("tasks", new MapValue(tasks), "longestM", new RealValue(0), "method", new TextValue(method)));
    }
}
