package org.sami.spn.json;

/** The stable codes of what readers refuse; docs/file-format.md explains them. */
final class Codes {
    static final String SYNTAX = "E-SYNTAX";
    static final String FILE = "E-FILE";
    static final String VERSION = "E-VERSION";
    static final String DOMAIN = "E-DOMAIN";
    static final String MISSING = "E-MISSING-MEMBER";
    static final String UNKNOWN_MEMBER = "E-UNKNOWN-MEMBER";
    static final String WRONG_TYPE = "E-WRONG-TYPE";
    static final String UNKNOWN_WORD = "E-UNKNOWN-WORD";
    static final String BAD_VALUE = "E-BAD-VALUE";
    static final String UNKNOWN_TYPE = "E-UNKNOWN-TYPE";
    static final String DUPLICATE = "E-DUPLICATE";
    static final String DANGLING = "E-DANGLING";
    static final String REQUIREMENT = "E-REQUIREMENT";
    static final String UNKNOWN_EVENT = "E-UNKNOWN-EVENT";
    static final String EVENT_SIDE = "E-EVENT-SIDE";
    static final String UNKNOWN_FIELD = "E-UNKNOWN-FIELD";
    static final String UNKNOWN_MARKUP = "E-UNKNOWN-MARKUP";
    static final String UNKNOWN_OPTION = "E-UNKNOWN-OPTION";
    static final String UNKNOWN_PLAN = "E-UNKNOWN-PLAN";
    static final String UNKNOWN_TASK = "E-UNKNOWN-TASK";
    static final String VARIABLE_NAME = "E-VARIABLE-NAME";
    static final String ANSWERS = "E-ANSWERS";
    static final String DECISION = "E-DECISION";
    static final String UNKNOWN_GLOBAL = "W-UNKNOWN-GLOBAL";

    private Codes() {}
}
