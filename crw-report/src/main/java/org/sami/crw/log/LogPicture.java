package org.sami.crw.log;

import java.awt.geom.Point2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.ReportWords;
import org.sami.crw.report.picture.TrackPicture;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/**
 * The picture of a log's track: its longest stretch and what is near that. A stretch far away, such as the position that
 * boats report before their first satellite fix, would shrink everything to a dot; the summary says that it is left out.
 */
final class LogPicture {
    private static final double MAX_GAP_M = 5000;
    private static final double MOST_LAT_DEG = 85;

    private LogPicture() {}

    /** The picture, or nothing where the log holds no position. */
    static Optional<byte[]> png(LogSummary summary) throws IOException {
        Optional<TrackSegment> main = main(summary);
        return main.isPresent() ? Optional.of(draw(summary, main.get())) : Optional.empty();
    }

    /** What the picture shows in its middle; the fixes, where the log has no poses. */
    private static Optional<TrackSegment> main(LogSummary summary) {
        Optional<TrackSegment> main =
                summary.poses().main().or(() -> summary.fixes().main());
        return main.filter(stretch -> Math.abs(stretch.first().latDeg()) <= MOST_LAT_DEG);
    }

    /** The stretches of poses that are too far away to be in the picture. */
    static List<TrackSegment> leftOut(LogSummary summary) {
        return main(summary)
                .map(main -> summary.poses().stretches().stream()
                        .filter(stretch -> !near(main, stretch))
                        .toList())
                .orElse(List.of());
    }

    private static boolean near(TrackSegment main, TrackSegment stretch) {
        return Geodesy.distanceM(main.first(), stretch.first()) <= MAX_GAP_M;
    }

    private static byte[] draw(LogSummary summary, TrackSegment main) throws IOException {
        LocalFrame plane = new LocalFrame(main.first().latDeg(), main.first().lonDeg());
        List<TrackPicture.Track> tracks = new ArrayList<>();
        for (TrackSegment stretch : summary.poses().stretches()) {
            if (near(main, stretch)) {
                tracks.add(track("stretch " + stretch.number(), stretch, plane));
            }
        }
        Stream<TrackSegment> fixes = summary.fixes().stretches().stream().filter(stretch -> near(main, stretch));
        List<Point2D> dots = List.of();
        if (tracks.isEmpty()) {
            fixes.forEach(stretch -> tracks.add(track("fixes " + stretch.number(), stretch, plane)));
        } else {
            dots = fixes.flatMap(stretch -> points(stretch, plane).stream()).toList();
        }
        return new TrackPicture(words(summary, main), tracks, dots).png();
    }

    private static TrackPicture.Track track(String name, TrackSegment stretch, LocalFrame plane) {
        String told = String.format(
                Locale.ROOT,
                "%.0f m in %s",
                stretch.distanceM(),
                ReportWords.duration(stretch.endMillis() - stretch.startMillis()));
        return new TrackPicture.Track(name, told, points(stretch, plane));
    }

    private static List<Point2D> points(TrackSegment stretch, LocalFrame plane) {
        return stretch.points().stream().map(point -> at(point, plane)).toList();
    }

    private static Point2D at(GeoPoint point, LocalFrame plane) {
        return new Point2D.Double(
                plane.eastM(point.latDeg(), point.lonDeg()), plane.northM(point.latDeg(), point.lonDeg()));
    }

    private static TrackPicture.Text words(LogSummary summary, TrackSegment main) {
        String title = String.valueOf(Path.of(summary.source()).getFileName());
        String subtitle = String.format(
                Locale.ROOT,
                "boat's log from %s on · %s · %.0f m · %d of %d lines read",
                summary.firstClock(),
                ReportWords.duration(summary.durationMillis()),
                summary.poses().distanceM(),
                summary.entries(),
                summary.lines());
        String axes = String.format(
                Locale.ROOT,
                "metres east and north of %.6f, %.6f",
                main.first().latDeg(),
                main.first().lonDeg());
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("poses", String.valueOf(summary.poses().positions()));
        facts.put("satellite fixes", String.valueOf(summary.fixes().positions()));
        facts.put("stretches", String.valueOf(summary.poses().stretchCount()));
        facts.put("not in the picture", String.valueOf(leftOut(summary).size()));
        facts.put("unread lines", String.valueOf(summary.unreadLines()));
        return new TrackPicture.Text(title, subtitle, axes, "satellite fix", facts);
    }
}
