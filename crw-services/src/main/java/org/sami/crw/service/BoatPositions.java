package org.sami.crw.service;

import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/** Where boats are, as far as the base knows. */
@FunctionalInterface
public interface BoatPositions {
    /** The position that a boat reported last; empty where it never reported one. */
    Optional<GeoPoint> positionOf(String boat);
}
