package org.sami.uav.handler;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Has the missions remember how often aircraft failed at their tasks, so that a base that goes on knows it. From any thread. */
final class TaskFailureMemory implements TaskFailures.Memory {
    private static final String KEY = "failures/";

    private final EngineHost host;

    TaskFailureMemory(EngineHost host) {
        this.host = host;
    }

    @Override
    public Map<String, TaskFailures.Failed> of(TaskId task) {
        Map<String, TaskFailures.Failed> found = new LinkedHashMap<>();
        host.ask(view -> view.memory(task.mission(), KEY + task.name()))
                .filter(MapValue.class::isInstance)
                .ifPresent(value -> ((MapValue) value).entries().forEach((aircraft, failed) -> {
                    if (aircraft instanceof ProxyValue one) {
                        failed(failed).ifPresent(known -> found.put(one.proxy(), known));
                    }
                }));
        return found;
    }

    private static Optional<TaskFailures.Failed> failed(Value value) {
        if (!(value instanceof ListValue list
                && !list.items().isEmpty()
                && list.items().get(0) instanceof IntegerValue times)) {
            return Optional.empty();
        }
        OptionalDouble percent = list.items().size() > 1 && list.items().get(1) instanceof RealValue charge
                ? OptionalDouble.of(charge.value())
                : OptionalDouble.empty();
        return Optional.of(new TaskFailures.Failed((int) times.value(), percent));
    }

    @Override
    public void keep(TaskId task, Map<String, TaskFailures.Failed> failures) {
        if (!host.ask(view -> view.mission(task.mission()).isPresent())) {
            return;
        }
        Map<Value, Value> all = new LinkedHashMap<>();
        failures.forEach((aircraft, failed) -> all.put(
                new ProxyValue(aircraft),
                new ListValue(
                        failed.percent().isPresent()
                                ? List.of(
                                        new IntegerValue(failed.times()),
                                        new RealValue(failed.percent().getAsDouble()))
                                : List.of(new IntegerValue(failed.times())))));
        host.post(List.of(new Input.Remember(task.mission(), KEY + task.name(), new MapValue(all))));
    }
}
