package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sami.petri.net.PetriNet;
import org.sami.petri.structure.StructuralProof.Method;

/**
 * Answers about all reachable markings of one net without a search through them: tried before a search, as many cost microseconds. An empty answer means that structure
 * does not prove it; it may hold all the same. Each proof holds with inhibitor and reset arcs too, or is not given. Invariants and siphons are computed once. For one thread.
 */
public final class StructuralAnswers {
    private final PetriNet net;
    private final StructureLimits limits;
    private final PlaceBounds bounds;
    private @Nullable InvariantSet invariants;
    private SiphonTrapCheck.@Nullable Result siphons;

    /** Answers for a net. */
    public StructuralAnswers(PetriNet net, StructureLimits limits) {
        this.net = net;
        this.limits = limits;
        this.bounds = new PlaceBounds(net, limits.millisLeft());
    }

    /** The minimal P-invariants without negative weights. */
    public InvariantSet invariants() {
        InvariantSet known = invariants;
        if (known == null) {
            known = Invariants.ofPlaces(net, limits);
            invariants = known;
        }
        return known;
    }

    /** Whether each siphon contains a marked trap. */
    public SiphonTrapCheck.Result siphons() {
        SiphonTrapCheck.Result known = siphons;
        if (known == null) {
            known = SiphonTrapCheck.check(net, limits);
            siphons = known;
        }
        return known;
    }

    /** The weights that bound a place lowest: a P-invariant where one gives a bound, else what the state equation gives. */
    public Optional<MarkingBound> bound(int place) {
        if (limits.cancelled().getAsBoolean()) {
            return Optional.empty();
        }
        Optional<MarkingBound> byInvariant = bounds.byInvariants(invariants(), place);
        return byInvariant.isPresent() || limits.cancelled().getAsBoolean()
                ? byInvariant
                : bounds.byStateEquation(place);
    }

    /** The most tokens that a place can have; empty where structure gives no bound. */
    public OptionalLong mostTokens(int place) {
        Optional<MarkingBound> bound = bound(place);
        return bound.isPresent() ? OptionalLong.of(bound.get().mostTokens(place)) : OptionalLong.empty();
    }

    /** That a condition holds in no reachable marking. */
    public Optional<StructuralProof> never(LinearCondition condition) {
        return StateEquation.refute(net, condition, invariants(), limits)
                .map(refutation -> new StructuralProof(
                        refutation.byInvariants() ? Method.INVARIANT : Method.STATE_EQUATION, refutation.words()));
    }

    /** That in every reachable marking a transition is enabled. */
    public Optional<StructuralProof> neverStops() {
        Optional<StructuralProof> bySiphons = neverStopsBySiphons();
        return bySiphons.isPresent() ? bySiphons : never(LinearCondition.dead(net));
    }

    /** The same, by siphons and traps alone. */
    Optional<StructuralProof> neverStopsBySiphons() {
        return siphons().holds()
                ? Optional.of(
                        new StructuralProof(Method.SIPHON_TRAP, words(siphons().pairs())))
                : Optional.empty();
    }

    /** That every transition can always fire again, whatever has fired; for free-choice nets only. */
    public Optional<StructuralProof> isLive() {
        return NetClass.isFreeChoice(net) ? neverStopsBySiphons() : Optional.empty();
    }

    private List<String> words(List<SiphonTrapCheck.Pair> pairs) {
        List<String> words = new ArrayList<>();
        for (SiphonTrapCheck.Pair pair : pairs) {
            String siphon = names(pair.siphon());
            words.add(
                    pair.trap().equals(pair.siphon())
                            ? siphon + " is a siphon and a trap, marked at first"
                            : "siphon " + siphon + " contains the trap " + names(pair.trap()) + ", marked at first");
        }
        return words;
    }

    private String names(BitSet places) {
        return places.stream().mapToObj(net::placeName).collect(Collectors.joining(", ", "{", "}"));
    }
}
