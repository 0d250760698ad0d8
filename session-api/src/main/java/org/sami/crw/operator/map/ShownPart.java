package org.sami.crw.operator.map;

import java.util.Objects;
import org.sami.crw.markup.MapRelevance.MapType;

/**
 * The part of the map to show, set by the last permitted event with the markup Relevant Area, or by a person who asked for a place.
 *
 * @param number among all views of the session, from 1: a window goes to a view with a new number
 * @param background the background below the layers
 * @param mission the event's mission; {@code Ids.NONE} for a person
 * @param why in words
 */
public record ShownPart(
        long number,
        double southDeg,
        double westDeg,
        double northDeg,
        double eastDeg,
        MapType background,
        long mission,
        String why) {

    public ShownPart {
        Objects.requireNonNull(background, "background");
        Objects.requireNonNull(why, "why");
    }
}
