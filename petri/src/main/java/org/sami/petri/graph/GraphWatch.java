package org.sami.petri.graph;

/** Follows a search from the thread that runs it, every few thousand states. */
public interface GraphWatch {
    /** Sees nothing and never stops a search. */
    GraphWatch NONE = new GraphWatch() {
        @Override
        public void looked(int states, int waiting) {}

        @Override
        public boolean isCancelled() {
            return false;
        }
    };

    /**
     * How far the search is.
     *
     * @param states how many states were looked at
     * @param waiting how many more are known
     */
    void looked(int states, int waiting);

    /** Whether the search is to end now. */
    boolean isCancelled();
}
