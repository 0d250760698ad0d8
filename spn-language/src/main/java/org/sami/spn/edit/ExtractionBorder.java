package org.sami.spn.edit;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The border of a selection that is to become a sub-mission. Tokens come in at one place of it, by transitions outside, and leave it by
 * transitions inside, to one place outside: so a static sub-mission that stands in its stead takes and returns them one by one, as before.
 *
 * @param entry the place inside at which tokens come in
 * @param exit the place outside to which they go
 */
record ExtractionBorder(Set<String> places, Set<String> transitions, String entry, String exit) {
    /**
     * Finds the border of a selection.
     *
     * @throws EditRefusedException saying which rule it does not keep, and where
     */
    static ExtractionBorder of(Plan plan, Set<String> selection, Vocabulary vocabulary) throws EditRefusedException {
        ElementNames names = new ElementNames(plan, vocabulary);
        UnaryOperator<String> name = id -> names.of(id).orElse(id);
        Set<String> places = new LinkedHashSet<>();
        Set<String> transitions = new LinkedHashSet<>();
        plan.places().stream().map(Place::id).filter(selection::contains).forEach(places::add);
        plan.transitions().stream()
                .map(Transition::id)
                .filter(selection::contains)
                .forEach(transitions::add);
        if (places.isEmpty() || transitions.isEmpty()) {
            throw new EditRefusedException(
                    "Select the places and transitions that become the sub-mission: at least one of each");
        }
        for (Place place : plan.places()) {
            if (places.contains(place.id()) && (place.start() || place.end())) {
                throw new EditRefusedException("The " + (place.start() ? "start " : "end ") + names.withKind(place)
                        + " has to stay in the plan \"" + plan.title() + "\": leave it out of the selection");
            }
        }
        for (InEdge edge : plan.inEdges()) {
            boolean from = places.contains(edge.place());
            if (from && !transitions.contains(edge.transition())) {
                throw new EditRefusedException("The transition \"" + name.apply(edge.transition())
                        + "\" outside takes tokens from \"" + name.apply(edge.place())
                        + "\" inside: select it, too, or leave \"" + name.apply(edge.place()) + "\" out");
            }
            if (!from && transitions.contains(edge.transition())) {
                throw new EditRefusedException(
                        "The transition \"" + name.apply(edge.transition()) + "\" inside takes tokens from \""
                                + name.apply(edge.place()) + "\" outside: select \"" + name.apply(edge.place())
                                + "\", too, or leave \"" + name.apply(edge.transition())
                                + "\" out");
            }
        }
        return new ExtractionBorder(
                places,
                transitions,
                only(
                        name,
                        ends(plan.outEdges(), transitions, places, false),
                        "Nothing outside leads into the selection: select from a place that a transition outside enters",
                        "Tokens come into the selection at ",
                        ": a sub-mission starts in one place"),
                only(
                        name,
                        ends(plan.outEdges(), transitions, places, true),
                        "Nothing leads out of the selection: a sub-mission has to return",
                        "Tokens leave the selection to ",
                        ": a sub-mission returns to one place"));
    }

    private static Set<String> ends(List<OutEdge> edges, Set<String> transitions, Set<String> places, boolean leaving) {
        Set<String> ends = new TreeSet<>();
        edges.stream()
                .filter(edge ->
                        transitions.contains(edge.transition()) == leaving && places.contains(edge.place()) != leaving)
                .forEach(edge -> ends.add(edge.place()));
        return ends;
    }

    private static String only(UnaryOperator<String> name, Set<String> ends, String none, String several, String rule)
            throws EditRefusedException {
        if (ends.isEmpty()) {
            throw new EditRefusedException(none);
        }
        if (ends.size() > 1) {
            throw new EditRefusedException(
                    several + ends.stream().map(name).collect(Collectors.joining("\" and \"", "\"", "\"")) + rule);
        }
        return ends.iterator().next();
    }

    /** Whether an edge lies inside. */
    boolean isInside(String place, String transition) {
        return places.contains(place) && transitions.contains(transition);
    }

    /** Whether an edge leads from outside to the entry. */
    boolean leadsIn(OutEdge edge) {
        return edge.place().equals(entry) && !transitions.contains(edge.transition());
    }

    /** Whether an edge leads from inside to the exit. */
    boolean leadsOut(OutEdge edge) {
        return edge.place().equals(exit) && transitions.contains(edge.transition());
    }
}
