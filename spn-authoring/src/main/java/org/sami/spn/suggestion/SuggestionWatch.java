package org.sami.spn.suggestion;

/** Receives the progress of a search for suggestions and can stop it; called on the search's thread. */
public interface SuggestionWatch {
    /** Nobody: the search runs to its end. */
    SuggestionWatch NONE = new SuggestionWatch() {
        @Override
        public void tried(int candidates, int all) {
            // nobody wants to know
        }

        @Override
        public boolean isCancelled() {
            return false;
        }
    };

    /**
     * Called before each candidate.
     *
     * @param candidates how many were tried
     * @param all how many there are
     */
    void tried(int candidates, int all);

    /** Whether to stop: the suggestions found until then are the result. */
    boolean isCancelled();
}
