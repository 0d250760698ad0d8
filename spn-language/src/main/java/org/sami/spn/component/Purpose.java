package org.sami.spn.component;

/** What the operator does with a value (thesis 5.2.4, Component capabilities). */
public enum Purpose {
    /** Gives a value that was not there before, such as a point on the map. */
    CREATE,
    /** Chooses from values that are there, or only sees them. */
    SELECT
}
