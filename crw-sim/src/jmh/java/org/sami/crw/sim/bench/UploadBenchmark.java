package org.sami.crw.sim.bench;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.figures.Figure;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;

/** A long waypoint list from its submission until the boat has been heard to hold it, to the last bit. */
final class UploadBenchmark {
    private static final int WARM_UP = 5;

    private final int waypoints;
    private final int uploads;

    UploadBenchmark(int waypoints, int uploads) {
        this.waypoints = waypoints;
        this.uploads = uploads;
    }

    /** The median in seconds; as error, how much longer the longest took. */
    List<Figure> run() throws Exception {
        try (FleetProcess fleet = new FleetProcess(1);
                MeasuredBase base = new MeasuredBase("bench-upload", 1)) {
            base.connect(fleet);
            List<Double> seconds = new ArrayList<>();
            for (int i = 0; i < WARM_UP + uploads; i++) {
                FollowPath path = path(i);
                long startNanos = System.nanoTime();
                base.submit("boat1", path);
                MeasuredBase.await("read back equal", () -> base.isReadBack("boat1", path.commandId()));
                if (i >= WARM_UP) {
                    seconds.add((System.nanoTime() - startNanos) / 1e9);
                }
            }
            Collections.sort(seconds);
            double median = seconds.get(uploads / 2);
            return List.of(new Figure(
                    "link.upload",
                    Map.of("waypoints", waypoints),
                    median,
                    "s until read back equal",
                    seconds.get(uploads - 1) - median));
        }
    }

    private FollowPath path(int number) {
        List<GeoPoint> points = new ArrayList<>(waypoints);
        for (int i = 0; i < waypoints; i++) {
            points.add(GeoPoint.of(FleetProcess.PIER.latDeg() + 0.01 + (i + number) * 1e-6 / 3, 10.9 + i * 1e-6 / 7));
        }
        return FollowPath.of("m1-a" + number + "-boat1", 1, number + 1, points, Priority.MEDIUM);
    }
}
