package org.sami.spn.wizard;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a change of a plan makes, as a preview shows it.
 *
 * @param vertices ids of new vertices
 * @param edges ids of new edges
 * @param changed ids of edges that were there and have other requirements now
 * @param lines a line for each, in words
 * @param summary all of it in a sentence or two
 */
public record PlanChange(
        Set<String> vertices, Set<String> edges, Set<String> changed, List<String> lines, String summary) {
    public PlanChange {
        vertices = Set.copyOf(vertices);
        edges = Set.copyOf(edges);
        changed = Set.copyOf(changed);
        lines = List.copyOf(lines);
        Objects.requireNonNull(summary, "summary");
    }

    /** What lies between two versions of a plan. */
    public static PlanChange between(Plan before, Plan after, Vocabulary vocabulary) {
        Comparison comparison = new Comparison(before, after, vocabulary);
        comparison.compareVertices();
        comparison.compareEdges();
        return new PlanChange(
                comparison.vertices, comparison.edges, comparison.changed, comparison.lines, comparison.summary());
    }

    private static final class Comparison {
        private final Plan before;
        private final Plan after;
        private final ElementNames names;
        private final Set<String> vertices = new LinkedHashSet<>();
        private final Set<String> edges = new LinkedHashSet<>();
        private final Set<String> changed = new LinkedHashSet<>();
        private final List<String> lines = new ArrayList<>();

        Comparison(Plan before, Plan after, Vocabulary vocabulary) {
            this.before = before;
            this.after = after;
            this.names = new ElementNames(after, vocabulary);
        }

        void compareVertices() {
            after.places().stream().filter(p -> before.place(p.id()).isEmpty()).forEach(p -> {
                vertices.add(p.id());
                lines.add("Place " + title(p.id()) + (p.start() ? ", the start of the plan" : ""));
            });
            after.transitions().stream()
                    .filter(t -> before.transition(t.id()).isEmpty())
                    .forEach(t -> {
                        vertices.add(t.id());
                        lines.add("Transition " + title(t.id()));
                    });
        }

        void compareEdges() {
            Map<String, List<String>> old = words(before);
            Map<String, List<String>> now = words(after);
            after.inEdges().forEach(e -> compare(e.id(), e.place(), e.transition(), old, now));
            after.outEdges().forEach(e -> compare(e.id(), e.transition(), e.place(), old, now));
        }

        private void compare(
                String edge, String from, String to, Map<String, List<String>> old, Map<String, List<String>> now) {
            String way = title(from) + " → " + title(to) + ": " + String.join(", ", now.get(edge));
            if (!old.containsKey(edge)) {
                edges.add(edge);
                lines.add("Edge " + way);
            } else if (!old.get(edge).equals(now.get(edge))) {
                changed.add(edge);
                lines.add("Changed " + way);
            }
        }

        String summary() {
            List<String> transitions = after.transitions().stream()
                    .map(t -> t.id())
                    .filter(vertices::contains)
                    .map(this::title)
                    .toList();
            int places = vertices.size() - transitions.size();
            List<String> drawn = new ArrayList<>();
            if (!transitions.isEmpty()) {
                drawn.add(count(transitions.size(), "transition") + " " + String.join(", ", transitions));
            }
            if (places > 0) {
                drawn.add(count(places, "place"));
            }
            if (!edges.isEmpty()) {
                drawn.add(count(edges.size(), "edge"));
            }
            return (drawn.isEmpty() ? "Draws nothing else." : "Draws " + String.join("; ", drawn) + ".")
                    + (changed.isEmpty() ? "" : " Changes the requirements of " + count(changed.size(), "edge") + ".");
        }

        private static String count(int n, String what) {
            return n + " " + what + (n == 1 ? "" : "s");
        }

        private static Map<String, List<String>> words(Plan plan) {
            Map<String, List<String>> words = plan.inEdges().stream()
                    .collect(Collectors.toMap(InEdge::id, e -> words(e.requirements(), RequirementWords::of)));
            words.putAll(plan.outEdges().stream()
                    .collect(Collectors.toMap(OutEdge::id, e -> words(e.requirements(), RequirementWords::of))));
            return words;
        }

        private static <R> List<String> words(List<R> requirements, Function<R, String> of) {
            return requirements.stream().map(of).toList();
        }

        private String title(String vertex) {
            return "\"" + names.of(vertex).orElse(vertex) + "\"";
        }
    }
}
