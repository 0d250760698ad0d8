package org.sami.spn.pattern;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.Edit;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wiring.WaysBack;
import org.sami.spn.wizard.InhibitedTransition;

/** All go on together when nobody can come any more: a transition that asks for somebody here and for nobody in each place before. */
final class WhenAllAreHere implements Pattern {
    @Override
    public String id() {
        return "when-all-are-here";
    }

    @Override
    public String title() {
        return "When all are here";
    }

    @Override
    public String help() {
        return "Select the place where they gather. A transition takes all of them on when nobody is left in a place before it; select places "
                + "before it as well to have only those empty.";
    }

    @Override
    public Optional<String> refusal(PatternSpot spot) {
        Optional<Place> here = here(spot);
        if (here.isEmpty()) {
            return Optional.of(
                    spot.places().isEmpty()
                            ? "Select the place where they gather"
                            : "None of the selected places is reached from all the others");
        }
        if (here.get().end()) {
            return Optional.of("The mission ends with the first who comes to " + spot.name(here.get()));
        }
        Optional<TokenKind> kind = new PlacesBefore(spot).kind(here.get().id());
        if (kind.isEmpty()) {
            return Optional.of("Neither robots nor tasks come to " + spot.name(here.get()));
        }
        return empty(spot, here.get(), kind.get()).isEmpty()
                ? Optional.of("Nobody can be missing in " + spot.name(here.get()) + ": nobody waits before it")
                : Optional.empty();
    }

    @Override
    public Edit edit(PatternSpot spot) {
        Place here = here(spot).orElseThrow();
        TokenKind kind = new PlacesBefore(spot).kind(here.id()).orElseThrow();
        InhibitedTransition drawn = new InhibitedTransition(
                here.id(), empty(spot, here, kind), kind, "All are here", "All together", false, spot.mode());
        return new PatternEdit(
                spot.plan().id(), title() + ": " + spot.name(here), (plan, context) -> drawn.drawn(plan));
    }

    /** The selected place that is reached from all others, over the fewest firings. */
    private static Optional<Place> here(PatternSpot spot) {
        List<Place> places = spot.places();
        return places.stream()
                .filter(p -> new WaysBack(spot.plan(), p.id())
                        .places()
                        .keySet()
                        .containsAll(places.stream().map(Place::id).toList()))
                .min(Comparator.comparingInt(p -> {
                    WaysBack ways = new WaysBack(spot.plan(), p.id());
                    return places.stream()
                            .mapToInt(other -> ways.places().get(other.id()))
                            .sum();
                }));
    }

    private static Set<String> empty(PatternSpot spot, Place here, TokenKind kind) {
        Set<String> chosen = new LinkedHashSet<>();
        spot.places().stream()
                .map(Place::id)
                .filter(id -> !id.equals(here.id()))
                .forEach(chosen::add);
        return chosen.isEmpty() ? new PlacesBefore(spot).onTheWay(List.of(here.id()), kind) : chosen;
    }
}
