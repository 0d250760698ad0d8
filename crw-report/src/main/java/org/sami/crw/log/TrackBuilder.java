package org.sami.crw.log;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/**
 * Joins positions to a track, and breaks it where no boat can have gone: the boats report a position of their own
 * making, hundreds of kilometres away, until the first satellite fix.
 */
final class TrackBuilder {
    /** Corrections of satellite fixes are below this; a jump is further. */
    private static final double JUMP_M = 100;

    private static final double JUMP_MPS = 20;

    /** A log with more breaks is damaged; what it shows is counted, not drawn. */
    static final int MOST_STRETCHES = 1000;

    private final List<TrackSegment> stretches = new ArrayList<>();
    private @Nullable Open open;
    private int count;
    private long positions;
    private double distanceM;

    /** The stretch that grows. */
    private static final class Open {
        private final ThinnedWay way;
        private final long firstLine;
        private final long startMillis;
        private long endMillis;
        private long positions = 1;
        private double distanceM;
        private GeoPoint last;

        Open(GeoPoint first, long firstLine, long startMillis) {
            way = new ThinnedWay(first);
            this.firstLine = firstLine;
            this.startMillis = startMillis;
            endMillis = startMillis;
            last = first;
        }

        void add(GeoPoint point, long atMillis, double movedM) {
            way.add(point);
            distanceM += movedM;
            positions++;
            last = point;
            endMillis = atMillis;
        }
    }

    /**
     * Adds a position.
     *
     * @param atMillis since the log's first entry
     * @return the number of the stretch that it is in
     */
    int add(GeoPoint point, long atMillis, long line) {
        positions++;
        double movedM = open == null ? 0 : Geodesy.distanceM(open.last, point);
        if (open == null || jumped(movedM, atMillis - open.endMillis)) {
            close();
            count++;
            open = new Open(point, line, atMillis);
        } else {
            distanceM += movedM;
            open.add(point, atMillis, movedM);
        }
        return count;
    }

    private static boolean jumped(double movedM, long millis) {
        return movedM > JUMP_M && movedM > JUMP_MPS * Math.max(0, millis) / 1000;
    }

    private void close() {
        if (open != null && stretches.size() < MOST_STRETCHES) {
            stretches.add(new TrackSegment(
                    count,
                    open.firstLine,
                    open.startMillis,
                    open.endMillis,
                    open.positions,
                    open.distanceM,
                    open.way.points()));
        }
        open = null;
    }

    /** The track; nothing is added any more. */
    LoggedTrack finish() {
        close();
        return new LoggedTrack(positions, distanceM, count, stretches);
    }
}
