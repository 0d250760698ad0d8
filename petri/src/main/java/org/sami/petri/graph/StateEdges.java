package org.sami.petri.graph;

/** The edges of the states that were looked at, in their order: the numbers of the states that follow, by enabled transition. For one thread. */
final class StateEdges {
    private final LongChunks starts = new LongChunks();
    private final IntChunks targets = new IntChunks();

    /** Begins the edges of the next state. */
    void begin() {
        starts.add(targets.size());
    }

    void add(int target) {
        targets.add(target);
    }

    /** By how many bytes it grows with so many edges and another state. */
    long bytesToAdd(int edges) {
        return starts.bytesToAdd(1) + targets.bytesToAdd(edges);
    }

    long bytes() {
        return starts.bytes() + targets.bytes();
    }

    /** How many states have been begun. */
    int states() {
        return (int) starts.size();
    }

    long size() {
        return targets.size();
    }

    long from(int state) {
        return starts.get(state);
    }

    long to(int state) {
        return state + 1 < starts.size() ? starts.get(state + 1L) : targets.size();
    }

    int target(long edge) {
        return targets.get(edge);
    }
}
