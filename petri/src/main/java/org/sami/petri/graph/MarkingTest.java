package org.sami.petri.graph;

/** A condition on markings. */
@FunctionalInterface
public interface MarkingTest {
    /**
     * Whether a marking fulfils it.
     *
     * @param marking tokens by place; the array is reused, and must be neither kept nor changed
     */
    boolean test(int[] marking);
}
