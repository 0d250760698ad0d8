package org.sami.crw.service.coverage;

import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/**
 * How far the charges of boats last.
 *
 * @param metres by boat, the distance for which its charge certainly lasts; a boat that has not reported is missing
 * @param homes the homes for whose ways charges have to last too; a boat without that condition is missing
 * @param recharged whether boats' batteries are swapped on the way
 * @param keepHome whether track is left out where a charge does not last for it and the way home, instead of being driven without the way home
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
