package org.sami.crw.handler.activation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * Where boats may go as far as an activation says: its fields {@code avoid}, areas that are not to be entered, and {@code within}, the
 * area to stay in. Without them all water is free.
 */
public final class Restrictions {
    static final String AVOID = "avoid";
    static final String WITHIN = "within";

    private Restrictions() {}

    /**
     * The water of an activation, on a plane that touches at a point near by.
     *
     * @param error how far boats may be off their ways in it
     * @throws IllegalArgumentException for an area that is no simple polygon
     */
    public static Water water(Activation activation, GeoPoint origin, CrossTrackError error) {
        return Water.of(origin, avoid(activation), within(activation)).drivenWith(error);
    }

    /** The areas that are not to be entered. */
    public static List<GeoArea> avoid(Activation activation) {
        List<GeoArea> avoid = new ArrayList<>();
        activation.value(AVOID).ifPresent(value -> {
            if (!(value instanceof ListValue list)) {
                throw new IllegalArgumentException("\"" + AVOID + "\" is no list of areas: " + value);
            }
            list.items().forEach(item -> avoid.add(area(item, AVOID)));
        });
        return avoid;
    }

    /** The area to stay in. */
    public static Optional<GeoArea> within(Activation activation) {
        return activation.value(WITHIN).map(value -> area(value, WITHIN));
    }

    /** A field that is an area. */
    public static GeoArea area(Value value, String field) {
        if (value instanceof GeoArea area) {
            return area;
        }
        throw new IllegalArgumentException("\"" + field + "\" is no area: " + value);
    }
}
