package org.sami.crw.decision;

import java.util.Objects;

/**
 * The mission, plan and event that ask a decision; empty text where unknown, or where the domain asks.
 *
 * @param plan id of the mission's plan
 * @param planTitle title of that plan
 * @param mission name of the mission
 * @param place id of the place whose output event asks
 * @param placeName name of that place
 * @param event label of the output event
 */
public record Asker(String plan, String planTitle, String mission, String place, String placeName, String event) {
    /** Not known, or the domain. */
    public static final Asker UNKNOWN = new Asker("", "", "", "", "", "");

    public Asker {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(planTitle, "planTitle");
        Objects.requireNonNull(mission, "mission");
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(placeName, "placeName");
        Objects.requireNonNull(event, "event");
    }
}
