package org.sami.crw.service.coverage;

import java.util.Map;

/**
 * How far the charges of boats last.
 *
 * @param metres by boat, what its charge is sure to last for; a boat that is missing has not said
 * @param recharged whether boats' batteries are swapped on the way
 */
public record Ranges(Map<String, Double> metres, boolean recharged) {
    /** Of no boat is known how far it gets. */
    public static final Ranges UNKNOWN = new Ranges(Map.of(), false);

    public Ranges {
        metres = Map.copyOf(metres);
    }

    /** Metres; infinite where it is not known. */
    double of(String boat) {
        return metres.getOrDefault(boat, Double.POSITIVE_INFINITY);
    }
}
