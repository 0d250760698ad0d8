package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.algorithm.MinimumDiameter;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Measures the part of an area that tracks cover, planned, reported or true: a point is covered when a track passes within half the spacing. */
public final class AreaCoverage {
    /** Bends of a track that are flatter than this part of the spacing make no difference. */
    private static final double FLAT = 1.0 / 500;

    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final LocalPlane plane;
    private final Geometry region;
    private final double spacingM;

    /**
     * What tracks leave of an area.
     *
     * @param areaM2 square metres of it together
     * @param parts its parts
     * @param inLargest a point in the largest of them; empty where nothing is left
     */
    public record Left(double areaM2, List<GeoArea> parts, Optional<GeoPoint> inLargest) {
        public Left {
            parts = List.copyOf(parts);
        }
    }

    private AreaCoverage(LocalPlane plane, Geometry region, double spacingM) {
        this.plane = plane;
        this.region = region;
        this.spacingM = spacingM;
    }

    /**
     * An area without what is not to be entered.
     *
     * @param spacingM distance between two lanes in metres
     * @throws IllegalArgumentException for an area that is no simple polygon
     */
    public static AreaCoverage of(GeoArea area, double spacingM, List<GeoArea> avoid, Optional<GeoArea> within) {
        LocalPlane plane = new LocalPlane(area.outline().get(0));
        return new AreaCoverage(plane, region(area, avoid, within, plane), spacingM);
    }

    /** What of an area may be entered, on a plane that touches at its first point. */
    static Geometry region(GeoArea area, List<GeoArea> avoid, Optional<GeoArea> within, LocalPlane plane) {
        return Water.of(area.outline().get(0), avoid, within).allowed(Areas.polygon(area, plane, "The area"));
    }

    /** What is to be covered, in square metres. */
    public double areaM2() {
        return region.getArea();
    }

    /** The part of it in percent that is covered where so many square metres are left. */
    public double percent(double leftM2) {
        return 100 * (1 - leftM2 / Math.max(1e-9, areaM2()));
    }

    /**
     * What boats likely miss between lanes without anybody seeing it, in words to go on with; empty where next to nothing is.
     *
     * @param positionM deviation of the position that boats know, in metres
     */
    public String likelyMissed(double positionM) {
        double widthM = new MinimumDiameter(region).getLength(); // lanes lie across it, evenly
        return MissedBetweenLanes.words(positionM, widthM / Math.ceil(widthM / spacingM), spacingM);
    }

    /** Metres between two points of the area, on the plane on which it is measured. */
    public double distanceM(GeoPoint one, GeoPoint other) {
        return plane.distanceM(one, other);
    }

    /** A track with fewer points, of which it covers nearly the same. */
    public List<GeoPoint> thinned(List<GeoPoint> track, int most) {
        LineString line = FACTORY.createLineString(
                track.stream().map(point -> Areas.coordinate(point, plane)).toArray(Coordinate[]::new));
        Coordinate[] kept = line.getCoordinates();
        for (double offM = FLAT * spacingM; kept.length > most; offM *= 2) {
            kept = DouglasPeuckerSimplifier.simplify(line, offM).getCoordinates();
        }
        return Arrays.stream(kept).map(place -> Areas.point(place, plane)).toList();
    }

    /** What tracks leave of it; a track of less than two points covers nothing. */
    public Left left(Collection<List<GeoPoint>> tracks) {
        List<List<Coordinate>> lines = new ArrayList<>();
        for (List<GeoPoint> track : tracks) {
            if (track.size() > 1) {
                lines.add(line(track));
            }
        }
        Geometry rest = lines.isEmpty() ? region : UncoveredArea.of(region, lines, spacingM / 2, MeanAxis.ofRad(lines));
        return new Left(rest.getArea(), UncoveredArea.areas(rest, plane), largest(rest));
    }

    private List<Coordinate> line(List<GeoPoint> track) {
        LineString line = FACTORY.createLineString(
                track.stream().map(point -> Areas.coordinate(point, plane)).toArray(Coordinate[]::new));
        return List.of(DouglasPeuckerSimplifier.simplify(line, FLAT * spacingM).getCoordinates());
    }

    private Optional<GeoPoint> largest(Geometry rest) {
        List<Geometry> polygons = new ArrayList<>();
        for (int i = 0; i < rest.getNumGeometries(); i++) {
            if (rest.getGeometryN(i) instanceof Polygon polygon && !polygon.isEmpty()) {
                polygons.add(polygon);
            }
        }
        return polygons.stream()
                .max(Comparator.comparingDouble(Geometry::getArea))
                .map(polygon -> Areas.point(polygon.getInteriorPoint().getCoordinate(), plane));
    }
}
