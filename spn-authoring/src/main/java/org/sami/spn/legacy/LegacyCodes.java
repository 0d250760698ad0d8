package org.sami.spn.legacy;

import java.util.Set;

/** The stable codes of the findings of an import; docs/import-legacy.md explains them. */
final class LegacyCodes {
    // the file is refused
    static final String SYNTAX = "E-SYNTAX";
    static final String FILE = "E-FILE";
    static final String FORMAT = "E-FORMAT";
    static final String VERSION = "E-VERSION";
    static final String MISSING = "E-MISSING-MEMBER";
    static final String WRONG_TYPE = "E-WRONG-TYPE";
    static final String UNKNOWN_WORD = "E-UNKNOWN-WORD";
    static final String DUPLICATE = "E-DUPLICATE";
    static final String DANGLING = "E-DANGLING";
    static final String UNREADABLE = "E-NO-PROJECT";
    static final String CYCLE = "E-CYCLE";
    static final String TABLE = "E-TABLE";

    // arrived otherwise than it stood there
    static final String UNKNOWN_MEMBER = "W-UNKNOWN-MEMBER";
    static final String UNKNOWN_EVENT = "W-UNKNOWN-EVENT";
    static final String UNKNOWN_FIELD = "W-UNKNOWN-FIELD";
    static final String UNKNOWN_MARKUP = "W-UNKNOWN-MARKUP";
    static final String UNKNOWN_OPTION = "W-UNKNOWN-OPTION";
    static final String UNKNOWN_CLASS = "W-UNKNOWN-CLASS";
    static final String BY_NAME = "N-BY-NAME";
    static final String EVENT_SIDE = "W-EVENT-SIDE";
    static final String VALUE = "W-VALUE";
    static final String NO_REQUIREMENT = "W-NO-REQUIREMENT";
    static final String REQUIREMENT = "W-REQUIREMENT";
    static final String PARALLEL_EDGE = "W-PARALLEL-EDGE";
    static final String ORDER = "W-ORDER";
    static final String VARIABLE = "W-VARIABLE";
    static final String VARIABLE_TYPE = "W-VARIABLE-TYPE";
    static final String PREFIX = "W-PREFIX";
    static final String MOVES_NOBODY = "W-MOVES-NOBODY";
    static final String MODE = "N-MODE";
    static final String DROPPED = "N-NOT-KEPT";
    static final String HEADING = "W-HEADING";
    static final String COPY_FOLDED = "N-COPY-FOLDED";
    static final String COPY_KEPT = "N-COPY-KEPT";
    static final String NOT_A_COPY = "N-COPY-WITHOUT-PLAN";
    static final String LEFT_BEHIND = "N-LEFT-BEHIND";

    /** Of what says less here than it did in the export. */
    static final Set<String> LOSSES =
            Set.of(UNKNOWN_MEMBER, UNKNOWN_EVENT, UNKNOWN_FIELD, UNKNOWN_MARKUP, UNKNOWN_OPTION, UNKNOWN_CLASS, VALUE);

    /** Of what arrived otherwise than it stood there; other findings name what the plans themselves say. */
    private static final Set<String> CHANGES =
            Set.of(NO_REQUIREMENT, REQUIREMENT, PARALLEL_EDGE, ORDER, EVENT_SIDE, DROPPED);

    static boolean isChange(String code) {
        return LOSSES.contains(code) || CHANGES.contains(code);
    }

    private LegacyCodes() {}
}
