package org.sami.petri.graph;

import java.util.Arrays;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Fires transitions on packed states of one layout: adds to each word what the transition changes in it. Transitions that reset places take a slower way. For
 * one thread.
 */
final class PackedFiring {
    /** The result of {@link #overflow} where every field is large enough. */
    static final int FITS = -1;

    private final PetriNet net;
    private final StateLayout layout;
    private final boolean[] resets;

    /** By transition: the places in which there are more tokens afterwards, and how many more; for those that reset, what they produce. */
    private final int[][] raised;

    private final int[][] raise;

    /** By transition: the words that change, and what is added to them. */
    private final int[][] words;

    private final long[][] added;
    private final int[] marking;

    PackedFiring(PetriNet net, StateLayout layout) {
        this.net = net;
        this.layout = layout;
        int transitions = net.transitionCount();
        resets = new boolean[transitions];
        raised = new int[transitions][];
        raise = new int[transitions][];
        words = new int[transitions][];
        added = new long[transitions][];
        marking = new int[net.placeCount()];
        for (int t = 0; t < transitions; t++) {
            resets[t] = !net.resets().isEmpty(t);
            compile(t);
        }
    }

    private void compile(int t) {
        ArcTable produced = net.produced();
        ArcTable consumed = net.consumed();
        int[] places = new int[produced.to(t) - produced.from(t)];
        int[] more = new int[places.length];
        int count = 0;
        for (int arc = produced.from(t); arc < produced.to(t); arc++) {
            int change = produced.weight(arc) - consumed.weight(t, produced.node(arc));
            if (change > 0) {
                places[count] = produced.node(arc);
                more[count++] = change;
            }
        }
        raised[t] = Arrays.copyOf(places, count);
        raise[t] = Arrays.copyOf(more, count);
        compileWords(t);
    }

    private void compileWords(int t) {
        ArcTable produced = net.produced();
        ArcTable consumed = net.consumed();
        int arcs = produced.to(t) - produced.from(t) + consumed.to(t) - consumed.from(t);
        int[] changed = new int[arcs];
        long[] sums = new long[arcs];
        int count = 0;
        for (int arc = consumed.from(t); arc < consumed.to(t); arc++) {
            count = change(changed, sums, count, consumed.node(arc), -consumed.weight(arc));
        }
        for (int arc = produced.from(t); arc < produced.to(t); arc++) {
            count = change(changed, sums, count, produced.node(arc), produced.weight(arc));
        }
        words[t] = Arrays.copyOf(changed, count);
        added[t] = Arrays.copyOf(sums, count);
    }

    private int change(int[] changed, long[] sums, int count, int place, long tokens) {
        int at = 0;
        while (at < count && changed[at] != layout.word(place)) {
            at++;
        }
        changed[at] = layout.word(place);
        sums[at] += tokens << layout.shift(place);
        return Math.max(count, at + 1);
    }

    /** The first place whose field is too small for the marking after a firing; {@link #FITS} where there is none. */
    int overflow(int transition, int[] before) {
        int[] places = raised[transition];
        int[] more = raise[transition];
        for (int i = 0; i < places.length; i++) {
            if ((long) before[places[i]] + more[i] > layout.most(places[i]) && !isReset(transition, places[i])) {
                return places[i];
            }
        }
        return resets[transition] ? overflowAfterReset(transition) : FITS;
    }

    private int overflowAfterReset(int transition) {
        ArcTable produced = net.produced();
        for (int arc = produced.from(transition); arc < produced.to(transition); arc++) {
            if (produced.weight(arc) > layout.most(produced.node(arc)) && isReset(transition, produced.node(arc))) {
                return produced.node(arc);
            }
        }
        return FITS;
    }

    /** The tokens that a place has after a firing. */
    long tokensAfter(int transition, int place, int[] before) {
        int rest =
                isReset(transition, place) ? 0 : before[place] - net.consumed().weight(transition, place);
        return (long) rest + net.produced().weight(transition, place);
    }

    private boolean isReset(int transition, int place) {
        return resets[transition] && net.resets().weight(transition, place) > 0;
    }

    /** Writes the state after a firing, which must fit. */
    void fire(int transition, long[] state, int[] before, long[] after) {
        for (int w = 0; w < after.length; w++) {
            after[w] = state[w];
        }
        if (resets[transition]) {
            fireWithResets(transition, before, after);
            return;
        }
        int[] changed = words[transition];
        long[] sums = added[transition];
        for (int i = 0; i < changed.length; i++) {
            after[changed[i]] += sums[i];
        }
    }

    private void fireWithResets(int transition, int[] before, long[] after) {
        fire(net, transition, before, marking);
        layout.pack(marking, after);
    }

    /** Writes the marking after a firing, in which no place has more tokens than an {@code int} holds. */
    static void fire(PetriNet net, int transition, int[] before, int[] after) {
        System.arraycopy(before, 0, after, 0, before.length);
        ArcTable consumed = net.consumed();
        for (int arc = consumed.from(transition); arc < consumed.to(transition); arc++) {
            after[consumed.node(arc)] -= consumed.weight(arc);
        }
        ArcTable emptied = net.resets();
        for (int arc = emptied.from(transition); arc < emptied.to(transition); arc++) {
            after[emptied.node(arc)] = 0;
        }
        ArcTable produced = net.produced();
        for (int arc = produced.from(transition); arc < produced.to(transition); arc++) {
            after[produced.node(arc)] += produced.weight(arc);
        }
    }
}
