package org.sami.spn.protocol;

/** Who answered a decision. */
public enum Answerer {
    OPERATOR,
    AUTONOMY
}
