package org.sami.crw.report;

import java.util.List;
import java.util.Objects;

/**
 * What one boat did.
 *
 * @param link how base and boat were joined
 * @param distanceM metres travelled
 * @param batteryPercent charge left, 0 to 100
 * @param recharges how often its battery was changed
 * @param mark the index of its identity mark: its colour, the same as in the window
 * @param track where it was, oldest first; the first point is its start
 */
public record BoatResult(
        String id,
        LinkResult link,
        double distanceM,
        double batteryPercent,
        int recharges,
        int mark,
        List<TrackPoint> track) {
    public BoatResult {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(link, "link");
        track = List.copyOf(track);
    }

    /** Whether it was ever off the ground. */
    public boolean flew() {
        return track.stream().anyMatch(point -> point.altM() != 0);
    }
}
