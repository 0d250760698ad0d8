package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/**
 * What is written on the edges of a plan, by the edge's id, a line for each requirement. The implied generic token (thesis, Table 4) is
 * not written: a transition that wants at least one generic token on one in edge, and takes one to one out edge.
 */
public final class EdgeWords {
    private static final InRequirement WANTS_ONE = InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 1);
    private static final OutRequirement TAKES_ONE = OutRequirement.of(Action.TAKE, 1, TokenKind.GENERIC);

    private EdgeWords() {}

    /** The lines of every edge; an empty list where only the implied generic token passes. */
    public static Map<String, List<String>> of(Plan plan) {
        Set<String> folded = foldedTransitions(plan);
        Map<String, List<String>> words = new LinkedHashMap<>();
        for (InEdge edge : plan.inEdges()) {
            List<String> lines = new ArrayList<>();
            for (InRequirement requirement : edge.requirements()) {
                if (!(folded.contains(edge.transition()) && requirement.equals(WANTS_ONE))) {
                    lines.add(RequirementWords.of(requirement));
                }
            }
            words.put(edge.id(), lines);
        }
        for (OutEdge edge : plan.outEdges()) {
            List<String> lines = new ArrayList<>();
            for (OutRequirement requirement : edge.requirements()) {
                if (!(folded.contains(edge.transition()) && requirement.equals(TAKES_ONE))) {
                    lines.add(RequirementWords.of(requirement));
                }
            }
            words.put(edge.id(), lines);
        }
        return words;
    }

    private static Set<String> foldedTransitions(Plan plan) {
        Set<String> folded = new LinkedHashSet<>();
        for (Transition transition : plan.transitions()) {
            long wants = plan.inEdgesOf(transition.id()).stream()
                    .filter(edge -> edge.requirements().contains(WANTS_ONE))
                    .count();
            long takes = plan.outEdgesOf(transition.id()).stream()
                    .filter(edge -> edge.requirements().contains(TAKES_ONE))
                    .count();
            if (wants == 1 && takes == 1) {
                folded.add(transition.id());
            }
        }
        return folded;
    }
}
