package org.sami.crw.report.picture;

import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.stream.Stream;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.RunReport;

/** From metres east and north of the area's centre to points of the picture; one scale for both axes, north is up. */
final class MapScale {
    private static final double LEAST_EXTENT_M = 40;

    private final Rectangle frame;
    private final double centreEastM;
    private final double centreNorthM;
    private final double pixelsPerMetre;

    private MapScale(Rectangle frame, double centreEastM, double centreNorthM, double pixelsPerMetre) {
        this.frame = frame;
        this.centreEastM = centreEastM;
        this.centreNorthM = centreNorthM;
        this.pixelsPerMetre = pixelsPerMetre;
    }

    /** The scale at which everything that happened is inside a frame with some room around it, however large the area is. */
    static MapScale fitting(RunReport report, Rectangle frame) {
        return fitting(points(report), frame);
    }

    /** The scale at which all points are inside a frame with some room around them; there is at least one. */
    static MapScale fitting(Stream<? extends Point2D> points, Rectangle frame) {
        double[] box = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        points.forEach(p -> {
            box[0] = Math.min(box[0], p.getX());
            box[1] = Math.min(box[1], p.getY());
            box[2] = Math.max(box[2], p.getX());
            box[3] = Math.max(box[3], p.getY());
        });
        double width = Math.max(LEAST_EXTENT_M, (box[2] - box[0]) * 1.12);
        double height = Math.max(LEAST_EXTENT_M, (box[3] - box[1]) * 1.12);
        double scale = Math.min(frame.width / width, frame.height / height);
        return new MapScale(frame, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2, scale);
    }

    private static Stream<Point2D> points(RunReport report) {
        Stream<Point2D> locations = report.locations().stream().map(l -> new Point2D.Double(l.eastM(), l.northM()));
        Stream<Point2D> tracks = report.boats().stream()
                .flatMap(b -> b.track().stream())
                .map(t -> new Point2D.Double(t.eastM(), t.northM()));
        Stream<MapPoint> areas = report.map().areas().stream()
                .filter(area -> area.kind() == MapArea.Kind.EXPLORED || area.kind() == MapArea.Kind.AVOIDED)
                .flatMap(area -> area.outline().stream());
        Stream<MapPoint> spots = report.map().spots().stream().map(MapSpot::at);
        Stream<Point2D> plan = Stream.concat(areas, spots).map(p -> new Point2D.Double(p.eastM(), p.northM()));
        Stream<Point2D> happened = Stream.concat(plan, Stream.concat(locations, tracks));
        Stream<Point2D> quay =
                report.header().place().quay().stream().map(p -> new Point2D.Double(p.eastM(), p.northM()));
        return Stream.concat(happened, report.boats().isEmpty() ? Stream.of(new Point2D.Double()) : quay);
    }

    Point2D at(double eastM, double northM) {
        return new Point2D.Double(x(eastM), y(northM));
    }

    double x(double eastM) {
        return frame.getCenterX() + (eastM - centreEastM) * pixelsPerMetre;
    }

    double y(double northM) {
        return frame.getCenterY() - (northM - centreNorthM) * pixelsPerMetre;
    }

    double pixels(double metres) {
        return metres * pixelsPerMetre;
    }

    double westM() {
        return centreEastM - frame.width / 2.0 / pixelsPerMetre;
    }

    double eastM() {
        return centreEastM + frame.width / 2.0 / pixelsPerMetre;
    }

    double southM() {
        return centreNorthM - frame.height / 2.0 / pixelsPerMetre;
    }

    double northM() {
        return centreNorthM + frame.height / 2.0 / pixelsPerMetre;
    }

    /** The greatest of 1, 2, 5, 10, 20, 50 ... metres that is no longer than so many pixels. */
    double roundMetres(double pixels) {
        double metres = pixels / pixelsPerMetre;
        double power = Math.pow(10, Math.floor(Math.log10(metres)));
        double digit = metres / power;
        return (digit >= 5 ? 5 : digit >= 2 ? 2 : 1) * power;
    }
}
