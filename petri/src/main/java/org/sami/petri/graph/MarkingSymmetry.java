package org.sami.petri.graph;

/** A symmetry of a net with its initial marking: markings that it makes equal have equal futures, so that a search looks at one of them only. */
@FunctionalInterface
public interface MarkingSymmetry {
    /** Changes a marking into the one that stands for all that are like it. */
    void normalize(int[] marking);
}
