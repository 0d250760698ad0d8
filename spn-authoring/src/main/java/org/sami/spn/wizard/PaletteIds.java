package org.sami.spn.wizard;

import org.sami.spn.edit.FreshIds;
import org.sami.spn.vocabulary.EventType;

/** The ids of what can be added to a plan, by which palettes, profiles and lessons name it: in kebab case, stable. */
public final class PaletteIds {
    /** A blank place. */
    public static final String BLANK_PLACE = "palette-blank-place";

    /** A blank transition. */
    public static final String BLANK_TRANSITION = "palette-blank-transition";

    private PaletteIds() {}

    /** An event of a type. */
    public static String event(EventType type) {
        return "palette-event-" + FreshIds.ofWords(type.name().replaceAll("([a-z0-9])([A-Z])", "$1-$2"));
    }

    /** A place that runs a plan. */
    public static String subMission(String plan) {
        return "palette-sub-mission-" + FreshIds.ofWords(plan);
    }
}
