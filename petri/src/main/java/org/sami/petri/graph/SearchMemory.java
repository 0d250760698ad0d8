package org.sami.petri.graph;

import org.jspecify.annotations.Nullable;

/**
 * What a search keeps of its states, and whether the budget of memory has room for more. The hash table doubles while twice all that is kept is within the budget;
 * then it gets as many slots as can be filled with it. For one thread.
 */
final class SearchMemory {
    /** A table that could grow by a smaller part than this one stays as it is: at most so much of the budget is left unused. */
    private static final int LEAST_GROWTH = 16;

    private final StateSpace space;
    private final IntChunks parents;
    private final IntChunks deadlocks;
    private final @Nullable StateEdges edges;
    private final long budget;

    /** Memory with a budget in bytes. */
    SearchMemory(StateSpace space, IntChunks parents, IntChunks deadlocks, @Nullable StateEdges edges, long budget) {
        this.space = space;
        this.parents = parents;
        this.deadlocks = deadlocks;
        this.edges = edges;
        this.budget = budget;
    }

    private long bytes() {
        return space.bytes() + parents.bytes() + deadlocks.bytes() + (edges == null ? 0 : edges.bytes());
    }

    /** How many bytes of the budget are not in use; below 0 where more is in use than it allows. */
    long room() {
        return budget - bytes();
    }

    /** Begins the edges of the next state, where edges are kept; whether so many of them, and the beginning of another state, have room. */
    boolean beginEdges(int count) {
        if (edges == null) {
            return true;
        }
        edges.begin();
        long more = edges.bytesToAdd(count);
        return more == 0 || more <= room();
    }

    /** Makes room for another state; false where the budget does not allow it. */
    boolean makeRoom() {
        StateTable table = space.table();
        if (table.isFull() && !growWithin(table)) {
            return false;
        }
        return table.bytesToAdd() + parents.bytesToAdd(1) <= room();
    }

    private boolean growWithin(StateTable table) {
        long slots = table.slots();
        long fitting = (long) (slots * ((double) budget / bytes())); // states and edges grow as the slots do
        int wanted = (int) Math.min(2 * slots, Math.min(fitting, StateTable.MOST_SLOTS));
        if (wanted < slots + slots / LEAST_GROWTH) {
            return false;
        }
        table.grow(wanted);
        return true;
    }

    /** The number of states from which on there may be no room for another one. */
    int nextGrowth() {
        return (int) Math.min(space.table().nextGrowth(), parents.capacity());
    }
}
