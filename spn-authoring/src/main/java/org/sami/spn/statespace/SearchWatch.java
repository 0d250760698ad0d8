package org.sami.spn.statespace;

/** Somebody who watches a search; called on the search's thread. */
public interface SearchWatch {
    /** Nobody: the search runs to its end. */
    SearchWatch NONE = new SearchWatch() {
        @Override
        public void looked(int states, int waiting) {
            // nobody wants to know
        }

        @Override
        public boolean isCancelled() {
            return false;
        }
    };

    /**
     * Receives the search's progress from time to time.
     *
     * @param states that were looked at
     * @param waiting that are known and were not looked at yet
     */
    void looked(int states, int waiting);

    /** Whether to stop: what was found until then is the result. */
    boolean isCancelled();
}
