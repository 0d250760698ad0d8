package org.sami.spn.model;

/** What an out requirement does with the tokens it selects (thesis 4.1.3). */
public enum Action {
    /** Remove from the pool and add to this edge's place. */
    TAKE,
    /** Remove from the pool. */
    CONSUME,
    /** Add a copy to this edge's place, remove nothing. */
    ADD
}
