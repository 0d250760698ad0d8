package org.sami.petri.graph;

import java.util.BitSet;

/** A symmetry of a net with its initial marking: markings that it makes equal have equal futures, so that a search looks at one of them only. */
public interface MarkingSymmetry {
    /** Changes a marking into the one that stands for all that are like it. */
    void normalize(int[] marking);

    /** Changes the marking to which a transition has led from one that was normal, at less cost. */
    void normalizeAfter(int transition, int[] marking);

    /**
     * The same as {@link #normalize}, with the way back.
     *
     * @return for each transition of the net with the changed marking the one that it is with the marking as it was
     */
    int[] normalizeAndTrace(int[] marking);

    /** The same as {@link #normalizeAfter}, with the way back. */
    int[] normalizeAfterAndTrace(int transition, int[] marking);

    /**
     * Leaves out enabled transitions that lead to a marking like that of another one that stays.
     *
     * @param enabled transitions; those that stay stand at its beginning afterwards
     * @param count how many there are
     * @return how many stay
     */
    int withoutAlike(int[] marking, int[] enabled, int count);

    /** Adds what holds for nodes that are like others: transitions that fire, and the most tokens of places. */
    void spread(BitSet fired, int[] mostTokens);
}
