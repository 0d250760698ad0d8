package org.sami.crw.decision;

import java.util.Objects;

/**
 * Who asks a decision; what is not known, or is not so where the domain asks, is empty text.
 *
 * @param plan id of the plan whose mission asks
 * @param planTitle what people call that plan
 * @param mission name of the mission
 * @param place id of the place whose output event asks
 * @param placeName what people call that place
 * @param event what people call the output event
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
