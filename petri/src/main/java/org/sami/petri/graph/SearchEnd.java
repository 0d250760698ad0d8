package org.sami.petri.graph;

/** Why a search ended. */
public enum SearchEnd {
    /** Every state that can be reached was looked at: what was not found does not exist. */
    COMPLETE("every state was looked at"),
    /** What was searched for was found. */
    FOUND("what was searched for was found"),
    /** The budget of states was used up. */
    STATES("the budget of states was used up"),
    /** The budget of memory was used up. */
    MEMORY("the budget of memory was used up"),
    /** The budget of time was used up. */
    TIME("the budget of time was used up"),
    /** The search was stopped from outside. */
    CANCELLED("the search was stopped"),
    /** A place would have had more tokens than can be counted. */
    TOKENS("a place would have had more than 2147483647 tokens");

    private final String words;

    SearchEnd(String words) {
        this.words = words;
    }

    /** The reason in words. */
    public String words() {
        return words;
    }

    /** Whether states may be missing: an answer that says that something never happens is no proof then. */
    public boolean isBounded() {
        return this != COMPLETE && this != FOUND;
    }
}
