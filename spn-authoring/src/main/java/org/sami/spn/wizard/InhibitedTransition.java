package org.sami.spn.wizard;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.edit.FreshIds;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Match;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

/**
 * A transition that fires when somebody stands in one place and nobody is left in others, and the place behind it. Its edges are locked:
 * what they ask for is the meaning of the whole.
 *
 * @param here where somebody must stand
 * @param empty where nobody must be left
 * @param kind of tokens that is looked at: any proxy or any task
 * @param name of the transition
 * @param behind name of the new place behind it
 * @param end whether that place is an end of the plan
 */
public record InhibitedTransition(
        String here, Set<String> empty, TokenKind kind, String name, String behind, boolean end, Mode mode) {
    /** Draws it into a plan, with a new place behind it. */
    public Plan drawn(Plan plan) {
        String place = new FreshIds(plan).take(FreshIds.ofWords(behind));
        List<Place> places = new ArrayList<>(plan.places());
        places.add(new Place(place, behind, false, end, false, mode, List.of(), List.of(), List.of()));
        return drawn(plan.withPlaces(places), place);
    }

    /** Draws it into a plan, into a place that is there. */
    public Plan drawn(Plan plan, String place) {
        FreshIds ids = new FreshIds(plan);
        String transition = ids.take(FreshIds.ofWords(name));
        List<InEdge> in = new ArrayList<>(plan.inEdges());
        in.add(edge(ids, here, transition, InRequirement.of(kind, Match.AT_LEAST, 1)));
        empty.forEach(p -> in.add(edge(ids, p, transition, InRequirement.of(kind, Match.ZERO, 0))));
        List<OutEdge> out = new ArrayList<>(plan.outEdges());
        out.add(new OutEdge(
                ids.take(transition + "-" + place),
                transition,
                place,
                mode,
                List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TOKEN)),
                true));
        List<Transition> transitions = new ArrayList<>(plan.transitions());
        transitions.add(new Transition(transition, name, mode, WaitFor.EACH, List.of()));
        return laidOut(plan.withTransitions(transitions).withInEdges(in).withOutEdges(out), transition, place);
    }

    private InEdge edge(FreshIds ids, String from, String transition, InRequirement requirement) {
        return new InEdge(ids.take(from + "-" + transition), from, transition, mode, List.of(requirement), true);
    }

    private Plan laidOut(Plan plan, String transition, String place) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        FreeSpace.behind(plan, here).ifPresent(at -> {
            layout.put(transition, at);
            if (!layout.containsKey(place)) {
                FreeSpace.behind(plan.withLayout(layout), transition).ifPresent(next -> layout.put(place, next));
            }
        });
        return plan.withLayout(layout);
    }
}
