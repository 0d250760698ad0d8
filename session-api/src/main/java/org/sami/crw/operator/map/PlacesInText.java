package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.value.GeoPoint;

/**
 * Finds the places that a message or a question names, as {@code 25.36159,51.52857}: what is said of places has them in its text alone, also in
 * journals of before. Pure functions.
 */
public final class PlacesInText {
    private static final Pattern PLACE =
            Pattern.compile("(?<![\\d.])(-?\\d{1,2}\\.\\d{4,8}), ?(-?\\d{1,3}\\.\\d{4,8})(?![\\d])");

    private PlacesInText() {}

    /** The places in their order, each once. */
    public static List<GeoPoint> of(String text) {
        List<GeoPoint> places = new ArrayList<>();
        Matcher found = PLACE.matcher(text);
        while (found.find()) {
            double latDeg = Double.parseDouble(found.group(1));
            double lonDeg = Double.parseDouble(found.group(2));
            if (Math.abs(latDeg) <= 90 && Math.abs(lonDeg) <= 180) {
                GeoPoint place = GeoPoint.of(latDeg, lonDeg);
                if (!places.contains(place)) {
                    places.add(place);
                }
            }
        }
        return List.copyOf(places);
    }
}
