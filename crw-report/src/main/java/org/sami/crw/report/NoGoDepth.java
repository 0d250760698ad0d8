package org.sami.crw.report;

import java.util.List;
import java.util.OptionalDouble;
import org.locationtech.jts.algorithm.locate.IndexedPointInAreaLocator;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Location;
import org.locationtech.jts.geom.util.GeometryFixer;

/**
 * How deep boats came into the areas that plan and project avoid, by their tracks. An area counts from the start of the run, whenever the plan
 * came to speak of it.
 */
public final class NoGoDepth {
    private static final GeometryFactory FACTORY = new GeometryFactory();

    /** Between two points of a track it is looked as often as this, in metres. */
    private static final double STEP_M = 0.25;

    private NoGoDepth() {}

    /** The deepest place of all, in metres from the area's edge; 0 where no boat was inside, empty where nothing is avoided. */
    public static OptionalDouble of(RunReport report) {
        return report.map().areas().stream()
                .filter(area -> area.kind() == MapArea.Kind.AVOIDED)
                .mapToDouble(area -> deepestM(area, report.boats()))
                .max();
    }

    /** How deep boats might come inside at most, as announced to the operator before they drove; 0 where nothing was announced, empty where nothing is avoided. */
    public static OptionalDouble announced(RunReport report) {
        boolean isAvoided = report.map().areas().stream().anyMatch(area -> area.kind() == MapArea.Kind.AVOIDED);
        return isAvoided ? OptionalDouble.of(report.map().announcedM().orElse(0)) : OptionalDouble.empty();
    }

    private static double deepestM(MapArea area, List<BoatResult> boats) {
        Geometry polygon = GeometryFixer.fix(FACTORY.createPolygon(
                ring(area.outline()), area.holes().stream().map(NoGoDepth::ring).toArray(LinearRing[]::new)));
        IndexedPointInAreaLocator inside = new IndexedPointInAreaLocator(polygon);
        Geometry edge = polygon.getBoundary();
        Envelope box = polygon.getEnvelopeInternal();
        double deepestM = 0;
        for (BoatResult boat : boats) {
            List<TrackPoint> track = boat.track();
            for (int i = 1; i < track.size(); i++) {
                Coordinate from = coordinate(track.get(i - 1));
                Coordinate to = coordinate(track.get(i));
                if (!box.intersects(from, to)) {
                    continue;
                }
                int steps = (int) Math.ceil(from.distance(to) / STEP_M);
                for (int step = 0; step <= steps; step++) {
                    double part = steps == 0 ? 0 : (double) step / steps;
                    Coordinate at = new Coordinate(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
                    if (inside.locate(at) == Location.INTERIOR) {
                        deepestM = Math.max(deepestM, edge.distance(FACTORY.createPoint(at)));
                    }
                }
            }
        }
        return deepestM;
    }

    private static Coordinate coordinate(TrackPoint point) {
        return new Coordinate(point.eastM(), point.northM());
    }

    private static LinearRing ring(List<MapPoint> points) {
        Coordinate[] coordinates = new Coordinate[points.size() + 1];
        for (int i = 0; i < points.size(); i++) {
            coordinates[i] = new Coordinate(points.get(i).eastM(), points.get(i).northM());
        }
        coordinates[points.size()] = coordinates[0].copy();
        return FACTORY.createLinearRing(coordinates);
    }
}
