package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.value.GeoPoint;

/**
 * Numbers the targets that cameras of vehicles follow, since MAVLink has none: what is near a target that was seen before, by any vehicle, is that one. For the
 * gateway's thread.
 */
final class SeenTargets {
    /** The number of the first; simulated copters in the same session number theirs from 1. */
    static final int FIRST = 1001;

    /** Two places that are nearer to one another are one target, in metres: the place of a target is as wrong as the camera's direction. */
    static final double SAME_M = 15;

    private static final int MOST = 1_000; // a detector that reports more is not believed

    private final List<GeoPoint> places = new ArrayList<>(); // where each was seen first

    /** The number of the target at a place; empty where it would be one too many. */
    OptionalInt number(GeoPoint at) {
        int nearest = -1;
        double nearestM = SAME_M;
        for (int i = 0; i < places.size(); i++) {
            GeoPoint known = places.get(i);
            double apartM = new LocalFrame(known.latDeg(), known.lonDeg()).distanceM(at.latDeg(), at.lonDeg());
            if (apartM < nearestM) {
                nearest = i;
                nearestM = apartM;
            }
        }
        if (nearest < 0 && places.size() < MOST) {
            nearest = places.size();
            places.add(at);
        }
        return nearest < 0 ? OptionalInt.empty() : OptionalInt.of(FIRST + nearest);
    }
}
