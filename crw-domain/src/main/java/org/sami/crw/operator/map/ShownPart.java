package org.sami.crw.operator.map;

import java.util.Objects;
import org.sami.crw.markup.MapRelevance.MapType;

/**
 * The part of the map that is to be seen, by the last event with the markup Relevant Area that was allowed to change it, or by a person
 * who asked where something is.
 *
 * @param number of all views of the session, from 1: a window goes to a view whose number it has not seen
 * @param background what lies below the layers
 * @param mission whose event it was; {@code Ids.NONE} for a person
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
