package org.sami.lessons.job;

import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/**
 * Values as text, so that values of two plans can be compared: tasks by the order of their making, and what an author has drawn on the map as
 * "drawn", wherever it lies, since no two people draw alike.
 */
final class CanonicalValue {
    static final String DRAWN = "drawn";

    private final Set<Value> drawn = new LinkedHashSet<>();
    private final Function<TaskId, Integer> numbers;

    /**
     * Values of a run.
     *
     * @param project whose authors have drawn
     * @param numbers the number of each task
     */
    CanonicalValue(Project project, Function<TaskId, Integer> numbers) {
        this.numbers = numbers;
        project.globals().forEach(variable -> variable.initial().ifPresent(this::addDrawn));
        for (Plan plan : project.plans()) {
            plan.variables().forEach(variable -> variable.initial().ifPresent(this::addDrawn));
            plan.tasks().forEach(task -> task.fields().values().forEach(this::addDrawn));
            for (Place place : plan.places()) {
                place.outputs().forEach(this::addDrawn);
            }
        }
    }

    private void addDrawn(OutputEventSpec output) {
        for (FieldSource source : output.fields().values()) {
            Optional<Value> given = source instanceof FieldSource.Fixed fixed
                    ? Optional.of(fixed.value())
                    : source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
            given.ifPresent(this::addDrawn);
        }
    }

    private void addDrawn(Value value) {
        if (value instanceof ListValue list) {
            list.items().forEach(this::addDrawn);
        } else if (value instanceof MapValue map) {
            map.entries().values().forEach(this::addDrawn);
        } else if (value instanceof GeoPoint || value instanceof GeoPath || value instanceof GeoArea) {
            drawn.add(value);
            if (value instanceof GeoPath path) {
                drawn.addAll(path.points());
            }
        }
    }

    String of(Value value) {
        if (drawn.contains(value)) {
            return DRAWN;
        } else if (value instanceof ListValue list) {
            return list.items().stream().map(this::of).collect(Collectors.joining(", ", "[", "]"));
        } else if (value instanceof MapValue map) {
            return map.entries().entrySet().stream()
                    .map(entry -> of(entry.getKey()) + ": " + of(entry.getValue()))
                    .sorted()
                    .collect(Collectors.joining(", ", "{", "}"));
        } else if (value instanceof RecordValue record) {
            return record.fields().entrySet().stream()
                    .map(entry -> entry.getKey() + ": " + of(entry.getValue()))
                    .sorted()
                    .collect(Collectors.joining(", ", record.type() + "{", "}"));
        } else if (value instanceof GeoPath path) {
            return path.points().stream().map(this::of).collect(Collectors.joining(" ", "path(", ")"));
        } else if (value instanceof GeoArea area) {
            return area.outline().stream().map(this::of).collect(Collectors.joining(" ", "area(", ")"));
        }
        return simple(value);
    }

    private String simple(Value value) {
        if (value instanceof BooleanValue is) {
            return String.valueOf(is.value());
        } else if (value instanceof IntegerValue number) {
            return String.valueOf(number.value());
        } else if (value instanceof RealValue number) {
            return String.valueOf(number.value());
        } else if (value instanceof TextValue text) {
            return text.value().strip().replaceAll("\\s+", " ").toLowerCase(Locale.ROOT);
        } else if (value instanceof DurationValue duration) {
            return duration.millis() + " ms";
        } else if (value instanceof EnumValue constant) {
            return constant.constant();
        } else if (value instanceof ProxyValue robot) {
            return robot.proxy();
        } else if (value instanceof TaskId task) {
            return "task " + numbers.apply(task);
        } else if (value instanceof GeoPoint point) {
            return String.format(Locale.ROOT, "(%.6f %.6f)", point.latDeg(), point.lonDeg());
        } else if (value instanceof VariableReference) {
            return "a variable";
        }
        return value instanceof PlanReference plan ? plan.toString() : "";
    }
}
