package org.sami.spn.vocabulary;

/** What autonomy answers when the markup Mixed Initiative Trigger lets it decide. */
public enum AutonomyAnswer {
    /** Nothing sensible: the operator must answer; a timer runs out without effect and says so. */
    NONE,
    YES,
    NO,
    /** All proxies that entered. */
    ALL,
    /** The first option: services put the best one first. */
    FIRST,
    /** The default values of the asked fields. */
    DEFAULTS
}
