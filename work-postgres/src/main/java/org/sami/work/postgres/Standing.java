package org.sami.work.postgres;

import java.util.List;

/**
 * How far work is on all machines.
 *
 * @param runs how many there are
 * @param done how many have a result
 * @param underWay how many somebody makes now
 * @param givenUp numbers of runs that are begun no more, as they ended their worker as often as they may
 * @param workers everybody who ever joined, in this order
 */
public record Standing(int runs, int done, int underWay, List<Integer> givenUp, List<Worker> workers) {
    public Standing {
        givenUp = List.copyOf(givenUp);
        workers = List.copyOf(workers);
    }

    /**
     * A process that joined.
     *
     * @param name machine and process
     * @param done how many results are its own
     * @param underWay how many runs it makes now
     * @param isThere whether its lease goes on
     */
    public record Worker(String name, int done, int underWay, boolean isThere) {}

    /** Whether no run is left that anybody would make. */
    public boolean isOver() {
        return done + givenUp.size() >= runs;
    }
}
