package org.sami.spn.pattern;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wiring.WaysBack;
import org.sami.spn.wizard.InhibitedTransition;

/** The mission ends when nobody is at work any more: where they are when they are done, and in no place before. */
final class UntilNoneIsLeft implements Pattern {
    @Override
    public String id() {
        return "until-none-is-left";
    }

    @Override
    public String title() {
        return "Until none is left";
    }

    @Override
    public String help() {
        return "Select the places where they are when they are done or have failed. The plan ends when somebody is there and nobody is left in a "
                + "place before; select places before as well to have only those empty.";
    }

    @Override
    public Optional<String> refusal(PatternSpot spot) {
        List<Place> done = done(spot);
        if (done.isEmpty()) {
            return Optional.of("Select the place where they are when they are done: nothing leads out of it");
        }
        Optional<Place> end = done.stream().filter(Place::end).findFirst();
        if (end.isPresent()) {
            return Optional.of("The mission ends with the first who comes to " + spot.name(end.get()));
        }
        Optional<TokenKind> kind = kind(spot, done);
        if (kind.isEmpty()) {
            return Optional.of("Neither robots nor tasks come to " + spot.name(done.get(0)));
        }
        return empty(spot, done, kind.get()).isEmpty()
                ? Optional.of("Nobody is at work before " + spot.name(done.get(0)))
                : Optional.empty();
    }

    @Override
    public Edit edit(PatternSpot spot) {
        List<Place> done = done(spot);
        TokenKind kind = kind(spot, done).orElseThrow();
        Set<String> empty = empty(spot, done, kind);
        return new PatternEdit(spot.plan().id(), title() + ": " + spot.name(done.get(0)), (plan, context) -> {
            Plan drawn = plan;
            Optional<String> end = Optional.empty();
            for (Place place : done) {
                InhibitedTransition transition =
                        new InhibitedTransition(place.id(), empty, kind, "None is left", "End", true, spot.mode());
                drawn = end.isPresent() ? transition.drawn(drawn, end.get()) : transition.drawn(drawn);
                end = Optional.of(last(drawn));
            }
            return drawn;
        });
    }

    private static String last(Plan plan) {
        return plan.outEdges().get(plan.outEdges().size() - 1).place();
    }

    private static List<Place> done(PatternSpot spot) {
        return spot.places().stream()
                .filter(p ->
                        spot.plan().inEdges().stream().noneMatch(e -> e.place().equals(p.id()) && WaysBack.isWay(e)))
                .toList();
    }

    private static Optional<TokenKind> kind(PatternSpot spot, List<Place> done) {
        PlacesBefore before = new PlacesBefore(spot);
        return done.stream()
                .map(p -> before.kind(p.id()))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private static Set<String> empty(PatternSpot spot, List<Place> done, TokenKind kind) {
        Set<String> chosen = new LinkedHashSet<>();
        spot.places().stream().filter(p -> !done.contains(p)).map(Place::id).forEach(chosen::add);
        return chosen.isEmpty()
                ? new PlacesBefore(spot).before(done.stream().map(Place::id).toList(), kind)
                : chosen;
    }
}
