package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.sami.petri.net.PetriNet;

/**
 * The siphon-trap property: each siphon contains a trap that is marked at first. In a marking without an enabled transition the places without tokens are a siphon, if
 * each transition consumes something and no more than one token of a place; where the property holds, a trap in it would have a token. So such a net never stops. That
 * holds with reset arcs too (an emptied place is consumed from, {@link ClosedPlaces}), but not with inhibitor arcs, which disable transitions without any place being
 * empty: there, and where a transition consumes several tokens of a place, this check says nothing.
 *
 * <p>In a free-choice net more follows from the property: every transition can always fire again (Commoner's theorem).
 *
 * <p>Source: Desel and Esparza, "Free Choice Petri Nets", 1995, proposition 4.11 and theorem 4.21; Murata 1989, section VI.B.
 */
public final class SiphonTrapCheck {
    private SiphonTrapCheck() {}

    /** A siphon and the trap in it that is marked at first. */
    public record Pair(BitSet siphon, BitSet trap) {}

    /**
     * What was found.
     *
     * @param holds whether each siphon contains a trap that is marked; then {@code pairs} has each minimal siphon with its trap
     * @param unmarked a siphon without a marked trap
     * @param why why the property was not decided; empty where it was
     */
    public record Result(boolean holds, List<Pair> pairs, Optional<BitSet> unmarked, String why) {
        public Result {
            pairs = List.copyOf(pairs);
        }

        static Result undecided(String why) {
            return new Result(false, List.of(), Optional.empty(), why);
        }
    }

    /** Why the property would not prove that a net never stops; empty where it would. */
    public static Optional<String> whyNotApplicable(PetriNet net) {
        if (net.transitionCount() == 0) {
            return Optional.of("the net has no transition");
        }
        if (net.inhibitors().size() > 0) {
            return Optional.of("the net has inhibitor arcs");
        }
        if (!NetClass.consumesSingleTokens(net)) {
            return Optional.of("a transition consumes several tokens of one place");
        }
        return Optional.empty();
    }

    /** Checks all minimal siphons. */
    public static Result check(PetriNet net, StructureLimits limits) {
        Optional<String> reason = whyNotApplicable(net);
        if (reason.isPresent()) {
            return Result.undecided(reason.get());
        }
        MinimalClosedSets.Result siphons = MinimalClosedSets.of(ClosedPlaces.siphons(net), limits);
        ClosedPlaces traps = ClosedPlaces.traps(net);
        List<Pair> pairs = new ArrayList<>();
        for (BitSet siphon : siphons.sets()) {
            BitSet trap = traps.greatestWithin(siphon);
            if (trap.stream().noneMatch(place -> net.initial(place) > 0)) {
                return new Result(false, pairs, Optional.of(siphon), "");
            }
            pairs.add(new Pair(siphon, trap));
        }
        return siphons.complete()
                ? new Result(true, pairs, Optional.empty(), "")
                : Result.undecided("not all siphons were computed");
    }
}
