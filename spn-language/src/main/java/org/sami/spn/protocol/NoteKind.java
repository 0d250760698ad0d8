package org.sami.spn.protocol;

/** Why the engine notes something. Nothing is dropped in silence. */
public enum NoteKind {
    /** No transition wants an occurrence, or nobody that it named is there any longer. */
    DISCARDED,
    /** An answer to a visit that has ended. */
    LATE,
    /** An answer naming nobody where tokens were asked for. */
    NAMES_NOBODY,
    /** Robots that an answer names, or that a filter kept, are gone: it is taken, or asked, for the others. */
    GONE,
    /** Fewer tokens were there than an out requirement asked for (thesis 4.1.3, "attempts to remove"). */
    SHORT_OF_TOKENS,
    /** A starting token did not come back from a sub-mission, or cannot: it entered when the static instance was over. */
    NOT_RETURNED,
    /** An interrupt found nothing to take. */
    INTERRUPT_REFUSED,
    /** A chain of firings without new input was stopped. */
    LIVELOCK,
    HANDLER_FAILED,
    /** An input that makes no sense in this state. */
    REJECTED_INPUT,
    /** A loaded project has another initial value for a global that has one already. */
    GLOBAL_KEPT,
    /** Autonomy was to answer and had no answer. */
    NO_AUTOMATIC_ANSWER
}
