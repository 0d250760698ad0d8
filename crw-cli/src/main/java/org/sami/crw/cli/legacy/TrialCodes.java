package org.sami.crw.cli.legacy;

import java.util.Set;

/** The stable codes of what trial runs find; docs/import-legacy.md explains them. */
final class TrialCodes {
    /** The engine or its host broke. */
    static final String ENGINE = "E-ENGINE";
    /** The plan fires without end. */
    static final String LIVELOCK = "E-RUN-LIVELOCK";
    /** The plan came to an event that nothing handles. */
    static final String UNHANDLED = "E-UNHANDLED-EVENT";

    static final String HANDLER_FAILED = "W-EVENT-FAILED";
    static final String UNANSWERED = "W-UNANSWERED";
    static final String NOT_TAKEN = "W-NOT-TAKEN";
    static final String SHORT_OF_TOKENS = "W-SHORT-OF-TOKENS";
    static final String NOT_RETURNED = "W-NOT-RETURNED";
    static final String NAMES_NOBODY = "W-NAMES-NOBODY";
    static final String COPIES = "W-COPIES";
    static final String MOVES_NOTHING = "W-MOVES-NOTHING";
    static final String REJECTED = "W-REJECTED";
    static final String LATE = "N-LATE-ANSWER";
    static final String INTERRUPT_REFUSED = "N-INTERRUPT-REFUSED";

    /** What no plan may make happen, however it is drawn. */
    static final Set<String> FAULTS = Set.of(ENGINE, LIVELOCK, UNHANDLED);

    private TrialCodes() {}
}
