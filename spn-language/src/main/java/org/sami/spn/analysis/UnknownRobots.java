package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * A value names robots that the plan or the project lists, where they list any: of robots whose names nobody says before the run nothing
 * is checked. Which fields hold names the vocabulary says.
 */
final class UnknownRobots implements PlanCheck {
    private static final Pattern NUMBER = Pattern.compile("[ -]?[0-9]+");

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-UNKNOWN-ROBOT",
                "The project has no robot of that name: the event is about nobody.",
                "Correct the name, or add the robot to the list of the project."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Set<String> listed = listed(plan);
        if (listed.isEmpty() || namesLater(plan)) {
            return;
        }
        for (KnownFields.Known known : plan.known().all()) {
            Set<String> named = new LinkedHashSet<>();
            addNamed(known.value(), named);
            named.removeIf(robot -> isListed(robot, listed));
            for (String robot : named) {
                report.accept(Finding.warning(
                        "W-UNKNOWN-ROBOT",
                        known.pointer(),
                        known.name() + " names \"" + robot + "\", which is not listed; listed are "
                                + String.join(", ", listed) + Suggestions.meant(listed, robot),
                        known.vertex(),
                        known.event()));
            }
        }
    }

    /** How many robots are listed; empty where none is, or where events add more. */
    static Optional<Integer> number(PlanContext plan) {
        boolean adds = plan.outputs().stream()
                .anyMatch(
                        o -> plan.vocabulary().robotNames().containsKey(o.type().name()));
        Set<String> listed = adds ? Set.of() : listed(plan);
        return listed.isEmpty() ? Optional.empty() : Optional.of(listed.size());
    }

    /** Whether an event names robots that are given when the mission runs. */
    private static boolean namesLater(PlanContext plan) {
        return plan.outputs().stream().anyMatch(output -> {
            String field = plan.vocabulary().robotNames().get(output.type().name());
            return field != null
                    && output.spec().fields().containsKey(field)
                    && KnownFields.of(plan, output).stream()
                            .noneMatch(known -> known.field().name().equals(field));
        });
    }

    /** Whether a name is one of those, or one of several robots that are numbered after it. */
    private static boolean isListed(String robot, Set<String> listed) {
        return listed.contains(robot)
                || listed.stream()
                        .anyMatch(name -> robot.startsWith(name)
                                && NUMBER.matcher(robot.substring(name.length()))
                                        .matches());
    }

    /** The names of the robots that records of the project and of the plan, and events of the plan, list. */
    private static Set<String> listed(PlanContext plan) {
        Set<String> names = new LinkedHashSet<>();
        List<Value> values = new ArrayList<>();
        Stream.concat(plan.project().globals().stream(), plan.plan().variables().stream())
                .map(VariableSpec::initial)
                .forEach(initial -> initial.ifPresent(values::add));
        for (KnownFields.Known known : plan.known().all()) {
            values.add(known.value());
        }
        values.forEach(value -> addListed(plan, value, names));
        plan.outputs().forEach(output -> {
            String field = plan.vocabulary().robotNames().get(output.type().name());
            if (field != null) {
                KnownFields.of(plan, output).stream()
                        .filter(known -> known.field().name().equals(field))
                        .forEach(known -> addText(known.value(), names));
            }
        });
        return names;
    }

    private static void addListed(PlanContext plan, Value value, Set<String> names) {
        if (value instanceof RecordValue record) {
            String field = plan.vocabulary().robotNames().get(record.type());
            if (field != null && record.fields().containsKey(field)) {
                addText(record.fields().get(field), names);
            }
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> addListed(plan, item, names));
        }
    }

    private static void addText(Value value, Set<String> names) {
        if (value instanceof TextValue text && !text.value().isBlank()) {
            names.add(text.value());
        }
    }

    private static void addNamed(Value value, Set<String> named) {
        if (value instanceof ProxyValue robot) {
            named.add(robot.proxy());
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> addNamed(item, named));
        } else if (value instanceof RecordValue record) {
            record.fields().values().forEach(part -> addNamed(part, named));
        } else if (value instanceof MapValue map) {
            map.entries().forEach((key, entry) -> {
                addNamed(key, named);
                addNamed(entry, named);
            });
        }
    }
}
