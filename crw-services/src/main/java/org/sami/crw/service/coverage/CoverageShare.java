package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/**
 * What one boat covers.
 *
 * @param approach the points at which its way to the track turns; empty where it goes there straight
 * @param track the points of the track in order
 * @param trackM the track's length
 * @param approachM the length of the way to it
 */
public record CoverageShare(List<GeoPoint> approach, List<GeoPoint> track, double trackM, double approachM) {
    public CoverageShare {
        approach = List.copyOf(approach);
        track = List.copyOf(track);
    }

    /** The length of all that the boat drives, in metres. */
    double drivenM() {
        return approachM + trackM;
    }

    /** All that the boat drives. */
    public GeoPath path() {
        List<GeoPoint> path = new ArrayList<>(approach);
        path.addAll(track);
        return new GeoPath(path);
    }
}
