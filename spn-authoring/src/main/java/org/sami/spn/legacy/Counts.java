package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.value.VariableReference;
import org.sami.spn.vocabulary.Reserved;

/** How many of each kind there are. Each side is counted by itself, on what it is: the export's tree, and the new project. */
public record Counts(Map<CountedKind, Integer> numbers) {
    public Counts {
        Map<CountedKind, Integer> all = new EnumMap<>(CountedKind.class);
        for (CountedKind kind : CountedKind.values()) {
            all.put(kind, numbers.getOrDefault(kind, 0));
        }
        numbers = all;
    }

    /** How many there are of a kind. */
    public int of(CountedKind kind) {
        return numbers.getOrDefault(kind, 0);
    }

    /** By their names in reports, in order. */
    public Map<String, Integer> byLabel() {
        Map<String, Integer> labelled = new LinkedHashMap<>();
        numbers.forEach((kind, n) -> labelled.put(kind.label(), n));
        return labelled;
    }

    Counts plus(Counts other) {
        Map<CountedKind, Integer> sum = new EnumMap<>(CountedKind.class);
        numbers.forEach((kind, n) -> sum.put(kind, n + other.of(kind)));
        return new Counts(sum);
    }

    Counts minus(Counts other) {
        Map<CountedKind, Integer> difference = new EnumMap<>(CountedKind.class);
        numbers.forEach((kind, n) -> difference.put(kind, n - other.of(kind)));
        return new Counts(difference);
    }

    /** Counts an export as it stands in its file, whatever becomes of it. */
    static Counts of(JsonNode document) {
        Tally tally = new Tally();
        tally.add(CountedKind.GLOBAL_VARIABLES, document.path("globalVariables").size());
        for (JsonNode plan : document.path("plans")) {
            tally.add(CountedKind.PLANS, 1);
            tally.add(CountedKind.TASKS, plan.path("tasks").size());
            Set<String> variables = new LinkedHashSet<>();
            plan.path("vertices").forEach(v -> count(v, tally, variables));
            plan.path("edges").forEach(e -> count(e, tally));
            tally.add(CountedKind.VARIABLES, variables.size());
        }
        return tally.counts();
    }

    private static void count(JsonNode vertex, Tally tally, Set<String> variables) {
        boolean place = vertex.path("type").asText().equals("place");
        tally.add(place ? CountedKind.PLACES : CountedKind.TRANSITIONS, 1);
        tally.add(CountedKind.SUB_MISSIONS, vertex.path("subMissions").size());
        for (JsonNode event : vertex.path("events")) {
            tally.add(place ? CountedKind.PLACE_EVENTS : CountedKind.TRANSITION_EVENTS, 1);
            tally.add(CountedKind.MARKUPS, event.path("markups").size());
            event.path("readVariables").forEach(v -> variables.add(v.asText()));
            event.path("writeVariables").forEach(v -> variables.add(v.asText()));
            for (JsonNode value : event.path("fieldValues")) {
                if (value.path("type").asText().equals("variable-name")) {
                    variables.add(value.path("name").asText());
                }
            }
        }
    }

    private static void count(JsonNode edge, Tally tally) {
        boolean in = edge.path("type").asText().equals("in");
        tally.add(in ? CountedKind.IN_EDGES : CountedKind.OUT_EDGES, 1);
        tally.add(
                in ? CountedKind.IN_REQUIREMENTS : CountedKind.OUT_REQUIREMENTS,
                edge.path("requirements").size());
    }

    /** Counts a project of this language. */
    public static Counts of(Project project) {
        Tally tally = new Tally();
        tally.add(CountedKind.GLOBAL_VARIABLES, project.globals().size());
        for (Plan plan : project.plans()) {
            tally.add(CountedKind.PLANS, 1);
            tally.add(CountedKind.TASKS, plan.tasks().size());
            tally.add(CountedKind.PLACES, plan.places().size());
            tally.add(CountedKind.TRANSITIONS, plan.transitions().size());
            tally.add(CountedKind.IN_EDGES, plan.inEdges().size());
            tally.add(CountedKind.OUT_EDGES, plan.outEdges().size());
            plan.inEdges()
                    .forEach(e -> tally.add(
                            CountedKind.IN_REQUIREMENTS, e.requirements().size()));
            plan.outEdges()
                    .forEach(e -> tally.add(
                            CountedKind.OUT_REQUIREMENTS, e.requirements().size()));
            plan.places().forEach(p -> count(p, tally));
            plan.transitions().forEach(t -> count(t, tally));
            tally.add(CountedKind.VARIABLES, variables(plan).size());
        }
        return tally.counts();
    }

    private static void count(Place place, Tally tally) {
        tally.add(CountedKind.SUB_MISSIONS, place.subMissions().size());
        tally.add(CountedKind.PLACE_EVENTS, place.outputs().size());
        place.outputs().forEach(e -> tally.add(CountedKind.MARKUPS, e.markups().size()));
    }

    private static void count(Transition transition, Tally tally) {
        tally.add(CountedKind.TRANSITION_EVENTS, transition.inputs().size());
        transition
                .inputs()
                .forEach(e -> tally.add(CountedKind.MARKUPS, e.markups().size()));
    }

    /** The variables that the events of a plan read, write or name. */
    static Set<String> variables(Plan plan) {
        Set<String> names = new LinkedHashSet<>();
        List<OutputEventSpec> outputs =
                plan.places().stream().flatMap(p -> p.outputs().stream()).toList();
        for (OutputEventSpec output : outputs) {
            names.addAll(output.writes().values());
            output.fields().values().forEach(source -> variable(source, names));
        }
        List<InputEventSpec> inputs =
                plan.transitions().stream().flatMap(t -> t.inputs().stream()).toList();
        inputs.forEach(i -> names.addAll(i.writes().values()));
        return names;
    }

    private static void variable(FieldSource source, Set<String> names) {
        if (source instanceof FieldSource.FromVariable from) {
            names.add(from.variable());
        } else if (source instanceof FieldSource.FromTask) {
            names.add(Reserved.TASK_VARIABLE);
        } else if (source instanceof FieldSource.Fixed fixed && fixed.value() instanceof VariableReference v) {
            names.add(v.variable());
        } else if (source instanceof FieldSource.Asked asked
                && asked.defaultValue().orElse(null) instanceof VariableReference v) {
            names.add(v.variable());
        }
    }

    /** A count while it is made. */
    static final class Tally {
        private final Map<CountedKind, Integer> numbers = new EnumMap<>(CountedKind.class);

        void add(CountedKind kind, int n) {
            numbers.merge(kind, n, Integer::sum);
        }

        Counts counts() {
            return new Counts(numbers);
        }
    }
}
