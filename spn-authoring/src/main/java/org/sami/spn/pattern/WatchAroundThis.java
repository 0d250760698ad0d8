package org.sami.spn.pattern;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FreshIds;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.WaitFor;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/**
 * A watch that a domain draws around a place, such as one for low batteries: robots leave the place when something happens, and come back.
 * Whoever waits until nobody is left in the place, or until all there have answered, waits for those as well who are away (thesis 7.0.3);
 * a transition that takes all takes them as well.
 */
final class WatchAroundThis implements Pattern {
    private final Sequence.Manual sequence;

    WatchAroundThis(Sequence.Manual sequence) {
        this.sequence = sequence;
    }

    @Override
    public String id() {
        return sequence.id();
    }

    @Override
    public String title() {
        return sequence.name();
    }

    @Override
    public String help() {
        return "Select a place where robots work. " + sequence.help();
    }

    @Override
    public Optional<String> refusal(PatternSpot spot) {
        List<Place> places = spot.places();
        if (places.size() != 1) {
            return Optional.of("Select one place where robots work");
        }
        Place place = places.get(0);
        if (place.end()) {
            return Optional.of("The mission ends in " + spot.name(place));
        }
        if (!spot.coming().comes(TokenType.PROXY, place.id())) {
            return Optional.of("No robots come to " + spot.name(place));
        }
        return place.outputs().stream().anyMatch(o -> o.type().equals(sequence.event()))
                ? Optional.of(spot.name(place) + " is watched already")
                : Optional.empty();
    }

    @Override
    public Edit edit(PatternSpot spot) {
        Place place = spot.places().get(0);
        AddEvent watch = AddEvent.usual(
                        spot.plan().id(),
                        sequence.event(),
                        new EventTarget.OnVertex(place.id()),
                        spot.mode(),
                        spot.library())
                .withSequence(sequence.id());
        return new PatternEdit(
                spot.plan().id(),
                title() + ": " + spot.name(place),
                (plan, context) -> alsoAway(plan, watch.change(plan, context), place.id()));
    }

    /** Lets each transition that looks at the watched place look at those where robots are away as well, where that makes a difference to them. */
    private Plan alsoAway(Plan before, Plan watched, String place) {
        List<InEdge> edges = new ArrayList<>(watched.inEdges());
        FreshIds ids = new FreshIds(watched);
        for (InEdge edge : before.inEdges()) {
            List<InRequirement> away = edge.place().equals(place) ? away(before, edge) : List.of();
            for (Place resting : watched.places()) {
                if (!away.isEmpty() && before.place(resting.id()).isEmpty()) {
                    edges.add(new InEdge(
                            ids.take(resting.id() + "-" + edge.transition()),
                            resting.id(),
                            edge.transition(),
                            edge.mode(),
                            away,
                            true));
                }
            }
        }
        return watched.withInEdges(edges);
    }

    /**
     * What a transition that looks at the watched place asks of those who are away: that none is, where it waits until nobody is left or until
     * all have answered; to come along, where it takes all tokens there. Nothing where it takes one after the other.
     */
    private static List<InRequirement> away(Plan plan, InEdge edge) {
        List<InRequirement> absent = edge.requirements().stream()
                .filter(r -> r.asksForNone() && (r.kind() == TokenKind.ANY_PROXY || r.kind() == TokenKind.ANY_TOKEN))
                .toList();
        if (!absent.isEmpty()) {
            return absent;
        }
        boolean waitsForAll = plan.transition(edge.transition())
                .filter(t -> t.waitFor() == WaitFor.ALL && !t.inputs().isEmpty())
                .isPresent();
        if (waitsForAll) {
            return List.of(InRequirement.of(TokenKind.ANY_PROXY, Match.ZERO, 0));
        }
        boolean takesWhoeverIsThere = edge.requirements().stream().allMatch(r -> r.kind() == TokenKind.UNCONDITIONAL)
                && plan.outEdgesOf(edge.transition()).stream()
                        .flatMap(e -> e.requirements().stream())
                        .anyMatch(r ->
                                r.takesAll() && (r.kind() == TokenKind.ANY_PROXY || r.kind() == TokenKind.ANY_TOKEN));
        return takesWhoeverIsThere ? edge.requirements() : List.of();
    }
}
