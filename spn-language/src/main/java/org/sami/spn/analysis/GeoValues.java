package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;

/**
 * The geographic values that a plan is known to use before it runs: those that stand in its fields, the defaults of what is asked, the
 * first values of its variables and of the project's that it reads, and those of its tasks.
 */
final class GeoValues {
    private final PlanContext plan;
    private final List<Known> known = new ArrayList<>();

    GeoValues(PlanContext plan) {
        this.plan = plan;
        Set<String> read = new HashSet<>(plan.plan().reads());
        for (PlacedOutput output : plan.outputs()) {
            output.spec().fields().forEach((field, source) -> {
                String pointer = output.pointer() + "/fields/" + field;
                if (source instanceof FieldSource.FromVariable from) {
                    read.add(from.variable());
                }
                given(source)
                        .ifPresent(value -> known.add(new Known(
                                field + " of " + plan.name(output),
                                value,
                                pointer + (source instanceof FieldSource.Fixed ? "/value" : "/default"),
                                output.spec().id())));
            });
        }
        variables(plan.plan().variables(), plan.pointer() + "/variables/");
        variables(
                plan.project().globals().stream()
                        .filter(global -> read.contains(global.name()))
                        .toList(),
                "/globals/");
        tasks();
    }

    private void variables(List<VariableSpec> variables, String pointer) {
        for (VariableSpec variable : variables) {
            int index = pointer.equals("/globals/")
                    ? plan.project().globals().indexOf(variable)
                    : plan.plan().variables().indexOf(variable);
            variable.initial()
                    .ifPresent(value -> known.add(
                            new Known(variable.name(), value, pointer + index + "/initial", variable.name())));
        }
    }

    private void tasks() {
        List<TaskSpec> tasks = plan.plan().tasks();
        for (int i = 0; i < tasks.size(); i++) {
            TaskSpec task = tasks.get(i);
            String pointer = plan.pointer() + "/tasks/" + i + "/fields/";
            task.fields()
                    .forEach((field, value) ->
                            known.add(new Known(task.name() + "." + field, value, pointer + field, task.name())));
        }
    }

    private static Optional<Value> given(FieldSource source) {
        if (source instanceof FieldSource.Fixed fixed) {
            return Optional.of(fixed.value());
        }
        return source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
    }

    /** All values, in the order of the document but the project's variables after the plan's. */
    List<Known> all() {
        return known;
    }

    /** The value that a field of an output event will have, where that is known: its own, or the first value of its variable. */
    Optional<Known> of(PlacedOutput output, String field) {
        FieldSource source = output.spec().fields().get(field);
        Optional<String> read =
                source instanceof FieldSource.FromVariable from ? Optional.of(from.variable()) : Optional.empty();
        String name = read.orElse(field + " of " + plan.name(output));
        String element = read.orElse(output.spec().id());
        return known.stream()
                .filter(k -> k.name().equals(name) && k.element().equals(element))
                .findFirst();
    }

    /**
     * A value whose place in the document is known.
     *
     * @param name a variable, or a field with its event or task, as messages speak of it
     * @param element what is to be highlighted
     */
    record Known(String name, Value value, String pointer, String element) {
        /** The points in it with their places, outlines of areas too; those of a list come in its order. */
        void points(BiConsumer<GeoPoint, String> each) {
            points(value, pointer, true, each);
        }

        /** The points in it where robots are to be: without outlines of areas. */
        void locations(BiConsumer<GeoPoint, String> each) {
            points(value, pointer, false, each);
        }

        private static void points(Value value, String at, boolean outlines, BiConsumer<GeoPoint, String> each) {
            if (value instanceof GeoPoint point) {
                each.accept(point, at);
            } else if (value instanceof GeoPath path) {
                list(path.points(), at, outlines, each);
            } else if (value instanceof GeoArea area && outlines) {
                list(area.outline(), at + "/outline", true, each);
            } else if (value instanceof ListValue list) {
                list(list.items(), at, outlines, each);
            } else if (value instanceof MapValue map) {
                for (Map.Entry<Value, Value> entry : map.entries().entrySet()) {
                    points(entry.getValue(), at, outlines, each);
                }
            } else if (value instanceof RecordValue record) {
                record.fields().forEach((field, part) -> points(part, at + "/" + field, outlines, each));
            }
        }

        private static void list(
                List<? extends Value> items, String at, boolean outlines, BiConsumer<GeoPoint, String> each) {
            for (int i = 0; i < items.size(); i++) {
                points(items.get(i), at + "/" + i, outlines, each);
            }
        }
    }
}
