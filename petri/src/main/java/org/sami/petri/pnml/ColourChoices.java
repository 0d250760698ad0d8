package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The choices of colours for the variables of a transition that fulfil its condition, the last variable first. Each part of a conjunction is looked at as soon as its
 * variables have colours, so that a choice of some of them that breaks it is not gone into. For one thread.
 */
final class ColourChoices {
    /** So many colours of single variables are tried in all transitions together. */
    private static final long MOST_TRIED = 20_000_000;

    /** A comparison of multisets takes as long as so many of single colours. */
    private static final long MULTISET = 20;

    private final ColourTerms terms;
    private final CompiledConditions compiled;
    private final List<String> names;
    private final int[] sizes;
    private final List<List<CompiledConditions.Truth>> parts =
            new ArrayList<>(); // by the number of variables that have to have colours
    private final int[] chosen;
    private int at = -1;
    private boolean hasBegun;
    private long tried;

    /** The choices for variables with their sorts, in that order. */
    ColourChoices(
            ColourDeclarations declared, ColourTerms terms, Map<String, ColourSort> variables, List<XmlTerm> conditions)
            throws RefusedPnmlException {
        this.terms = terms;
        names = List.copyOf(variables.keySet());
        compiled = new CompiledConditions(declared, terms, names);
        sizes = variables.values().stream().mapToInt(sort -> (int) sort.size()).toArray();
        chosen = new int[sizes.length];
        Arrays.fill(chosen, -1);
        for (int i = 0; i <= sizes.length; i++) {
            parts.add(new ArrayList<>());
        }
        for (XmlTerm condition : conditions) {
            enter(condition);
        }
    }

    private void enter(XmlTerm condition) throws RefusedPnmlException {
        if (condition.name().equals("and")) {
            for (XmlTerm part : condition.arguments()) {
                enter(part);
            }
            return;
        }
        Map<String, ColourSort> used = new LinkedHashMap<>();
        terms.variables(condition, used);
        int needed = used.keySet().stream().mapToInt(names::indexOf).max().orElse(-1) + 1;
        parts.get(needed).add(compiled.of(condition));
    }

    /**
     * Goes on to the next choice; false after the last one.
     *
     * @param before how many colours were tried for other transitions
     * @param line of the transition
     * @throws RefusedPnmlException if too many were tried, or the condition makes no sense
     */
    boolean next(long before, int line) throws RefusedPnmlException {
        if (!hasBegun) {
            hasBegun = true;
            at = holds(0) ? 0 : -1;
            if (sizes.length == 0) {
                return at-- == 0;
            }
        }
        while (at >= 0) {
            if (++chosen[at] >= sizes[at]) {
                chosen[at--] = -1;
                continue;
            }
            tried++;
            if (before + tried() > MOST_TRIED) {
                throw new RefusedPnmlException(
                        "E-SIZE",
                        line,
                        "the variables have too many colours: " + MOST_TRIED + " choices were tried,"
                                + " where a comparison of multisets counts as " + MULTISET);
            }
            if (holds(at + 1)) {
                if (at + 1 == sizes.length) {
                    return true;
                }
                at++;
            }
        }
        return false;
    }

    private boolean holds(int variables) throws RefusedPnmlException {
        for (CompiledConditions.Truth part : parts.get(variables)) {
            if (!part.holds(chosen)) {
                return false;
            }
        }
        return true;
    }

    /** The colours that are chosen, by variable. */
    Map<String, Integer> values() {
        return compiled.values(chosen);
    }

    /** How many colours of single variables were tried so far, and what comparisons of multisets count. */
    long tried() {
        return tried + MULTISET * compiled.multisets();
    }
}
