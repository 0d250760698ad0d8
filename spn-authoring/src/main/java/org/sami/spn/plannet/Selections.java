package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/**
 * The out requirements of one transition as far as they select tokens (thesis 4.1.3). Requirements of one kind with numbers select from the same tokens in the
 * same order, so those of a smaller number are among those of a larger one: a level for each number. Immutable.
 */
final class Selections {
    /**
     * One requirement.
     *
     * @param edge its number among the out edges
     * @param level with a number: which of its group's numbers it is, from 1; else 0
     */
    record Selector(int edge, OutRequirement requirement, int level) {
        boolean removes() {
            return requirement.action() != Action.ADD;
        }

        boolean adds() {
            return requirement.action() != Action.CONSUME;
        }

        boolean isOf(TokenKind kind) {
            return requirement.kind() == kind;
        }
    }

    private final List<OutEdge> edges;
    private final List<Selector> selectors = new ArrayList<>();
    private final Map<String, List<Integer>> numbers = new TreeMap<>();

    Selections(Transition t, List<OutEdge> edges) {
        this.edges = edges;
        Map<String, TreeSet<Integer>> found = new TreeMap<>();
        for (OutEdge edge : edges) {
            for (OutRequirement r : edge.requirements()) {
                if (isNumbered(r)) {
                    found.computeIfAbsent(group(r), g -> new TreeSet<>()).add(r.n());
                }
            }
        }
        found.forEach((group, all) -> numbers.put(group, List.copyOf(all)));
        for (int i = 0; i < edges.size(); i++) {
            for (OutRequirement r : edges.get(i).requirements()) {
                if (r.kind() != TokenKind.UNCONDITIONAL) {
                    int level = isNumbered(r)
                            ? numbers.getOrDefault(group(r), List.of()).indexOf(r.n()) + 1
                            : 0;
                    selectors.add(new Selector(i, r, level));
                }
            }
        }
    }

    private static boolean isNumbered(OutRequirement r) {
        return !r.takesAll()
                && r.kind() != TokenKind.UNCONDITIONAL
                && r.kind() != TokenKind.SUB_MISSION_TOKENS
                && !(r.kind() == TokenKind.GENERIC && r.action() == Action.ADD);
    }

    /** Requirements with equal groups select from the same tokens. */
    static String group(OutRequirement r) {
        boolean isName = r.kind() == TokenKind.RELEVANT && r.action() == Action.ADD;
        return isName ? "NAMED" : r.kind() + r.task();
    }

    List<Selector> all() {
        return selectors;
    }

    /** The numbers of each group, the smallest first. */
    Map<String, List<Integer>> numbers() {
        return numbers;
    }

    /** For each number of sub-mission tokens that a requirement takes: what a token is behind that is not among those; first 0. */
    List<Integer> subMissionNumbers() {
        List<Integer> least = new ArrayList<>(List.of(0));
        boolean takesMore = selectors.stream()
                        .filter(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS))
                        .count()
                > 1;
        selectors.stream()
                .filter(s -> takesMore
                        && s.isOf(TokenKind.SUB_MISSION_TOKENS)
                        && !s.requirement().takesAll())
                .map(s -> s.requirement().n() + 1)
                .distinct()
                .sorted()
                .forEach(least::add);
        return least;
    }

    List<OutEdge> edges() {
        return edges;
    }

    String target(int edge) {
        return edges.get(edge).place();
    }
}
