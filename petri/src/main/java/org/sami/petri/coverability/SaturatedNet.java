package org.sami.petri.coverability;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/**
 * A net in which some places only say whether they have tokens: one token stands for any number, and who consumes it may leave one. Each marking of the net itself has
 * its image here, so what this net never does the net never does; and there are finitely many where only these places gather tokens without bound. Immutable.
 *
 * <p>A firing here is sure if the net can do it from every marking that the one before stands for, and comes to one that the one after stands for, or to one with more
 * tokens in these places.
 */
public final class SaturatedNet {
    private final PetriNet net;
    private final BitSet places;
    private final List<Integer> originals = new ArrayList<>();
    private final BitSet sure = new BitSet();

    private SaturatedNet(PetriNet original, BitSet places) {
        this.places = (BitSet) places.clone();
        SaturablePlaces rules = new SaturablePlaces(original);
        PetriNetBuilder builder = new PetriNetBuilder(original.name());
        for (int place = 0; place < original.placeCount(); place++) {
            int initial = original.initial(place);
            builder.place(original.placeId(place), places.get(place) ? Math.min(1, initial) : initial);
        }
        for (int t = 0; t < original.transitionCount(); t++) {
            List<Integer> choices = new ArrayList<>();
            boolean isSure = true;
            for (int place = places.nextSetBit(0); place >= 0; place = places.nextSetBit(place + 1)) {
                if (!rules.isExact(place)) {
                    isSure &= original.inhibitors().weight(t, place) == 0;
                    if (rules.lowersByOne(t, place)) {
                        choices.add(place);
                    }
                }
            }
            for (int variant = 0; variant < 1 << choices.size(); variant++) {
                add(builder, original, t, choices, variant);
                sure.set(originals.size(), isSure && variant == 0);
                originals.add(t);
            }
        }
        net = builder.build();
    }

    /**
     * The net with places saturated.
     *
     * @throws IllegalArgumentException if one of them cannot be, by {@link SaturablePlaces}
     */
    public static SaturatedNet of(PetriNet net, BitSet places) {
        SaturablePlaces rules = new SaturablePlaces(net);
        places.stream().filter(place -> !rules.contains(place)).findFirst().ifPresent(place -> {
            throw new IllegalArgumentException("place " + net.placeId(place) + " is counted beyond one token");
        });
        return new SaturatedNet(net, places);
    }

    /** @param variant which of the chosen places keep a token: a bit for each */
    private void add(PetriNetBuilder builder, PetriNet original, int t, List<Integer> choices, int variant) {
        String id = original.transitionId(t);
        String free = id;
        for (int i = variant + 1; builder.hasTransition(free); i++) {
            free = id + "~" + i;
        }
        int number = builder.transition(free);
        ArcTable consumed = original.consumed();
        for (int arc = consumed.from(t); arc < consumed.to(t); arc++) {
            builder.consume(number, consumed.node(arc), consumed.weight(arc));
        }
        ArcTable inhibitors = original.inhibitors();
        for (int arc = inhibitors.from(t); arc < inhibitors.to(t); arc++) {
            builder.inhibit(number, inhibitors.node(arc), inhibitors.weight(arc));
        }
        ArcTable resets = original.resets();
        for (int arc = resets.from(t); arc < resets.to(t); arc++) {
            builder.reset(number, resets.node(arc));
        }
        ArcTable produced = original.produced();
        for (int arc = produced.from(t); arc < produced.to(t); arc++) {
            int place = produced.node(arc);
            if (!places.get(place)) {
                builder.produce(number, place, produced.weight(arc));
            } else {
                builder.produce(number, place, 1);
                if (consumed.weight(t, place) == 0 && resets.weight(t, place) == 0) {
                    builder.reset(number, place); // there may be one already
                }
            }
        }
        for (int i = 0; i < choices.size(); i++) {
            if ((variant & (1 << i)) != 0) {
                builder.produce(number, choices.get(i), 1);
            }
        }
    }

    /** The net: places have the numbers that they have in the net itself. */
    public PetriNet net() {
        return net;
    }

    /** The places that say only whether they have tokens. */
    public BitSet places() {
        return (BitSet) places.clone();
    }

    /** The transition of the net itself that one stands for. */
    public int original(int transition) {
        return originals.get(transition);
    }

    boolean isSure(int transition) {
        return sure.get(transition);
    }
}
