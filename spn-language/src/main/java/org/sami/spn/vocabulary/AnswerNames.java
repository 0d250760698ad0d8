package org.sami.spn.vocabulary;

/** Whom the occurrence names that answers a decision. */
public enum AnswerNames {
    NOBODY,
    /** The proxies that the operator chose. */
    CHOSEN,
    /** The proxies and tasks of the tokens that entered. */
    ENTERING
}
