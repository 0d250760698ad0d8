package org.sami.spn.legacy;

/** What an import counts, in the export and in what came of it. */
public enum CountedKind {
    PLANS("plans"),
    PLACES("places"),
    TRANSITIONS("transitions"),
    IN_EDGES("inEdges"),
    OUT_EDGES("outEdges"),
    IN_REQUIREMENTS("inRequirements"),
    OUT_REQUIREMENTS("outRequirements"),
    PLACE_EVENTS("eventsOnPlaces"),
    TRANSITION_EVENTS("eventsOnTransitions"),
    MARKUPS("markups"),
    SUB_MISSIONS("subMissions"),
    TASKS("tasks"),
    GLOBAL_VARIABLES("globalVariables"),
    /** Distinct names that the events of a plan read, write or name, summed over the plans; globals included. */
    VARIABLES("variables");

    private final String label;

    CountedKind(String label) {
        this.label = label;
    }

    /** Its name in reports. */
    public String label() {
        return label;
    }
}
