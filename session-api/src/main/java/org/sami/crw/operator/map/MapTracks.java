package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** Where boats were: a bounded number of points each, the older the farther apart. For the owner's thread. */
public final class MapTracks {
    private static final int MOST_POINTS = 600;
    private static final double STEP_M = 1;

    private final Map<String, Track> tracks = new TreeMap<>();

    private static final class Track {
        private final List<ShownTrack.Point> points = new ArrayList<>();
        private Optional<ShownTrack> snapshot = Optional.empty();
    }

    /** A boat is somewhere. Gives whether its track has changed. */
    public boolean at(String boat, GeoPoint position, long atMillis) {
        Track track = tracks.computeIfAbsent(boat, id -> new Track());
        boolean still = !track.points.isEmpty() && Geodesy.distanceM(last(track).position(), position) < STEP_M;
        if (still) {
            return false;
        }
        track.points.add(new ShownTrack.Point(position, atMillis));
        track.snapshot = Optional.empty();
        if (track.points.size() > MOST_POINTS) {
            thin(track.points);
        }
        return true;
    }

    private static ShownTrack.Point last(Track track) {
        return track.points.get(track.points.size() - 1);
    }

    /** Of the older half every second point goes. */
    private static void thin(List<ShownTrack.Point> points) {
        List<ShownTrack.Point> thinned = new ArrayList<>();
        int half = points.size() / 2;
        for (int i = 0; i < points.size(); i++) {
            if (i >= half || i % 2 == 0) {
                thinned.add(points.get(i));
            }
        }
        points.clear();
        points.addAll(thinned);
    }

    public void remove(String boat) {
        tracks.remove(boat);
    }

    public void clear() {
        tracks.clear();
    }

    public List<ShownTrack> snapshots() {
        List<ShownTrack> all = new ArrayList<>();
        tracks.forEach((boat, track) -> {
            if (track.snapshot.isEmpty()) {
                track.snapshot = Optional.of(new ShownTrack(boat, track.points));
            }
            all.add(track.snapshot.get());
        });
        return all;
    }
}
