package org.sami.crw.service.coverage;

import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/**
 * How far the charges of boats last.
 *
 * @param metres by boat, what its charge is sure to last for; a boat that is missing has not said
 * @param homes where boats return to for which charges are to last as well; none for a boat that is not looked at so
 * @param recharged whether boats' batteries are swapped on the way
 * @param keepHome whether what charges do not last for together with the ways home is left, rather than driven without them
 */
public record Ranges(Map<String, Double> metres, Map<String, GeoPoint> homes, boolean recharged, boolean keepHome) {
    /** Of no boat is known how far it gets. */
    public static final Ranges UNKNOWN = new Ranges(Map.of(), Map.of(), false, false);

    public Ranges {
        metres = Map.copyOf(metres);
        homes = Map.copyOf(homes);
    }

    /** Of boats that stay where their tracks end. */
    public static Ranges out(Map<String, Double> metres, boolean recharged) {
        return new Ranges(metres, Map.of(), recharged, false);
    }

    /** Metres; infinite where it is not known. */
    double of(String boat) {
        return metres.getOrDefault(boat, Double.POSITIVE_INFINITY);
    }

    Optional<GeoPoint> home(String boat) {
        return Optional.ofNullable(homes.get(boat));
    }
}
