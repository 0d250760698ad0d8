package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/**
 * Decides whether the copy that a place runs still says what its plan says, but for the names of variables: then the place
 * can run the plan itself. The earlier system copied a plan into each place that ran it, renamed the copy
 * {@code prefix.Plan} and its variables {@code @prefix.variable}; authors then changed either.
 */
final class CopyCheck {
    private final LegacyPlan copy;
    private final LegacyPlan plan;
    private final Set<String> globals;
    private final Map<String, String> keys = new HashMap<>();
    private final Map<String, String> variables = new LinkedHashMap<>();
    private final Set<String> taken = new HashSet<>();

    private CopyCheck(LegacyPlan copy, LegacyPlan plan, Set<String> globals) {
        this.copy = copy;
        this.plan = plan;
        this.globals = globals;
    }

    /**
     * What came of a comparison.
     *
     * @param variables the copy's variable for each of the plan's, where they differ
     * @param difference the first thing that the copy says otherwise, in words; empty for a true copy
     */
    record Result(Map<String, String> variables, String difference) {
        boolean isTrue() {
            return difference.isEmpty();
        }
    }

    static Result compare(LegacyPlan copy, LegacyPlan plan, Set<String> globals) {
        CopyCheck check = new CopyCheck(copy, plan, globals);
        String difference = check.difference();
        Map<String, String> renamed = new LinkedHashMap<>(check.variables);
        renamed.entrySet().removeIf(e -> e.getKey().equals(e.getValue()));
        return new Result(renamed, difference);
    }

    private String difference() {
        if (copy.vertices().size() != plan.vertices().size()) {
            return "it has " + copy.vertices().size() + " places and transitions, not "
                    + plan.vertices().size();
        }
        if (copy.edges().size() != plan.edges().size()) {
            return "it has " + copy.edges().size() + " edges, not "
                    + plan.edges().size();
        }
        if (!tasks(copy).equals(tasks(plan))) {
            return "its tasks are others";
        }
        for (int i = 0; i < copy.vertices().size(); i++) {
            keys.put(copy.vertices().get(i).key(), plan.vertices().get(i).key());
        }
        for (int i = 0; i < copy.vertices().size(); i++) {
            String what = difference(copy.vertices().get(i), plan.vertices().get(i));
            if (!what.isEmpty()) {
                return "its " + copy.vertices().get(i).title() + " has other " + what + " than "
                        + plan.vertices().get(i).title();
            }
        }
        return edges(copy, keys::get).equals(edges(plan, UnaryOperator.identity()))
                ? ""
                : "its edges or their requirements are others";
    }

    private static List<String> tasks(LegacyPlan plan) {
        return plan.tasks().stream().map(t -> t.name() + " " + t.className()).toList();
    }

    private String difference(LegacyPlan.Vertex a, LegacyPlan.Vertex b) {
        if (a.place() != b.place()
                || !a.name().equals(b.name())
                || a.mode() != b.mode()
                || a.start() != b.start()
                || a.end() != b.end()
                || a.endsShared() != b.endsShared()) {
            return "properties";
        }
        if (!renamed(a.outTransitions()).equals(b.outTransitions())
                || !renamed(a.inPlaces()).equals(b.inPlaces())
                || !renamed(a.outPlaces()).equals(b.outPlaces())) {
            return "neighbours or another order of them";
        }
        if (!subMissions(a).equals(subMissions(b))) {
            return "sub-missions";
        }
        if (a.events().size() != b.events().size()) {
            return "events";
        }
        for (int i = 0; i < a.events().size(); i++) {
            if (!same(a.events().get(i), b.events().get(i))) {
                return "values, variables or markups in "
                        + a.events().get(i).className().replaceAll(".*\\.", "");
            }
        }
        return "";
    }

    private List<String> renamed(List<String> copyKeys) {
        return copyKeys.stream().map(k -> keys.getOrDefault(k, "?" + k)).toList();
    }

    private static List<String> subMissions(LegacyPlan.Vertex v) {
        return v.subMissions().stream()
                .map(s -> s.plan() + " " + s.shared() + " " + s.tasks())
                .toList();
    }

    private boolean same(LegacyPlan.Event a, LegacyPlan.Event b) {
        return a.className().equals(b.className())
                && a.editable().equals(b.editable())
                && markups(a).equals(markups(b))
                && a.values().keySet().equals(b.values().keySet())
                && a.values().entrySet().stream()
                        .allMatch(value -> Optional.ofNullable(b.values().get(value.getKey()))
                                .filter(other -> sameValue(value.getValue().node(), other.node()))
                                .isPresent())
                && sameVariables(a.reads(), b.reads())
                && sameVariables(a.writes(), b.writes());
    }

    private static List<String> markups(LegacyPlan.Event e) {
        return e.markups().stream()
                .map(m -> m.className() + said(m.options()) + said(m.parameters()))
                .toList();
    }

    private static String said(Map<String, LegacyValue> fields) {
        return fields.entrySet().stream()
                .map(f -> f.getKey() + f.getValue().node())
                .collect(Collectors.joining(",", "{", "}"));
    }

    private boolean sameValue(JsonNode a, JsonNode b) {
        boolean names = a.path("type").asText().equals("variable-name");
        return (names && b.path("type").asText().equals("variable-name"))
                ? sameVariable(a.path("name").asText(), b.path("name").asText())
                : a.equals(b);
    }

    private boolean sameVariables(Map<String, String> a, Map<String, String> b) {
        return a.keySet().equals(b.keySet())
                && a.entrySet().stream()
                        .allMatch(read -> sameVariable(read.getValue(), b.getOrDefault(read.getKey(), "")));
    }

    /** Each variable of the plan is one of the copy, everywhere the same, and no two are one; globals are themselves. */
    private boolean sameVariable(String inCopy, String inPlan) {
        if (globals.contains(inCopy) || globals.contains(inPlan)) {
            return inCopy.equals(inPlan);
        }
        String known = variables.get(inPlan);
        if (known != null) {
            return known.equals(inCopy);
        }
        variables.put(inPlan, inCopy);
        return taken.add(inCopy);
    }

    private static List<String> edges(LegacyPlan plan, UnaryOperator<String> key) {
        return plan.edges().stream()
                .map(e -> (e.in() ? "in " : "out ") + key.apply(e.from()) + " " + key.apply(e.to()) + " " + e.mode()
                        + " "
                        + e.requirements().stream()
                                .map(r -> r.kind() + " " + r.match() + " " + r.quantity() + " " + r.task() + " "
                                        + r.move())
                                .toList())
                .sorted()
                .toList();
    }
}
