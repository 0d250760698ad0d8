package org.sami.crw.service.water;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import org.locationtech.jts.algorithm.construct.MaximumInscribedCircle;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Point;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.operation.buffer.BufferOp;
import org.locationtech.jts.operation.buffer.BufferParameters;
import org.locationtech.jts.operation.distance.DistanceOp;
import org.locationtech.jts.operation.union.UnaryUnionOp;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * The water in which boats may go: everything, or an area, without obstacles and no-go areas. On a plane, so for one operating area.
 * Immutable.
 */
public final class Water {
    /** How far what is forbidden reaches around an area to stay in: once around the world. */
    private static final double RIM_M = 40_000_000;

    /** Factor between shrinking and growing again: what then lacks is only what was narrow. */
    private static final double GROWN_AGAIN = 1.05;

    /** The part of half its width that is taken from both sides of what is narrow. */
    private static final double MIDDLE = 0.9;

    private static final double ROUNDING_M = 0.01;

    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final LocalPlane plane;
    private final Geometry noGo;
    private final Geometry outside; // of the area to stay in
    private final Geometry forbidden; // both
    private final CrossTrackError error;
    private final Map<Object, Object> derived; // what is computed from the forbidden areas alone, by its key

    private Water(LocalPlane plane, Geometry noGo, Geometry outside, Geometry forbidden, CrossTrackError error) {
        this(plane, noGo, outside, forbidden, error, new ConcurrentHashMap<>());
    }

    private Water(
            LocalPlane plane,
            Geometry noGo,
            Geometry outside,
            Geometry forbidden,
            CrossTrackError error,
            Map<Object, Object> derived) {
        this.derived = derived;
        this.plane = plane;
        this.noGo = noGo;
        this.outside = outside;
        this.forbidden = forbidden;
        this.error = error;
    }

    /** Water without anything in it. */
    public static Water open(GeoPoint origin) {
        return of(origin, List.of(), Optional.empty());
    }

    /**
     * Water with areas that are not to be entered; they may overlap.
     *
     * @param origin a point near by
     * @param within the area to stay in, if there is one
     * @throws IllegalArgumentException for an area that is no simple polygon
     */
    public static Water of(GeoPoint origin, List<GeoArea> noGo, Optional<GeoArea> within) {
        LocalPlane plane = new LocalPlane(origin);
        List<Geometry> parts = new ArrayList<>();
        for (int i = 0; i < noGo.size(); i++) {
            parts.add(Areas.polygon(noGo.get(i), plane, "No-go area " + (i + 1)));
        }
        Geometry areas = union(parts);
        Optional<Geometry> outside = within.map(area -> outside(Areas.polygon(area, plane, "The area to stay in")));
        outside.ifPresent(parts::add);
        return new Water(
                plane,
                areas,
                outside.orElseGet(FACTORY::createPolygon),
                outside.isPresent() ? union(parts) : areas,
                CrossTrackError.NONE);
    }

    /** The water of a polygon on a plane. */
    public static Water inside(LocalPlane plane, Geometry polygon) {
        Geometry outside = outside(polygon);
        return new Water(plane, FACTORY.createPolygon(), outside, outside, CrossTrackError.NONE);
    }

    private static Geometry outside(Geometry polygon) {
        Envelope world = new Envelope(polygon.getEnvelopeInternal());
        world.expandBy(RIM_M);
        return FACTORY.toGeometry(world).difference(polygon);
    }

    private static Geometry union(List<Geometry> parts) {
        Geometry union = UnaryUnionOp.union(parts, FACTORY);
        return union == null ? FACTORY.createPolygon() : union;
    }

    /** The same water, for boats with this cross-track error. */
    public Water drivenWith(CrossTrackError other) {
        return new Water(plane, noGo, outside, forbidden, other, derived);
    }

    /**
     * What is computed from the forbidden areas alone, such as a graph of ways around them: computed once for this water and those that differ from it
     * in the cross-track error only.
     *
     * @param key names it, with equality
     * @param compute called where it is not known yet; may be called by two threads at a time, and then must return equals
     */
    public <T> T derived(Object key, Class<T> type, Supplier<T> compute) {
        Object known = derived.get(key);
        if (known == null) {
            known = compute.get();
            derived.put(key, known);
        }
        return type.cast(known);
    }

    /** The same water for a boat that is to go to a point: one outside of the area to stay in is not kept in. */
    public Water leaving(GeoPoint to) {
        boolean leaves = !outside.isEmpty() && outside.distance(FACTORY.createPoint(coordinate(to))) == 0;
        return leaves ? new Water(plane, noGo, FACTORY.createPolygon(), noGo, error) : this;
    }

    /** The cross-track error of boats here; none by default. */
    public CrossTrackError error() {
        return error;
    }

    /** What plans keep from what is forbidden here, for boats with that error. */
    public SafetyMargin margin() {
        return new SafetyMargin(error);
    }

    /**
     * The same water with what is forbidden shrunk at its rim. Where it is narrower than twice the depth, a tenth of its width stays forbidden in
     * the middle.
     *
     * @param depthM how much is taken off the rim, in metres, from 0
     */
    public Water shrunk(double depthM) {
        return new Water(
                plane,
                core(noGo, depthM),
                outside.buffer(-depthM),
                union(List.of(core(noGo, depthM), outside.buffer(-depthM))),
                error);
    }

    private static Geometry core(Geometry areas, double depthM) {
        if (areas.isEmpty() || depthM == 0) {
            return areas;
        }
        List<Geometry> parts = new ArrayList<>(List.of(areas.buffer(-depthM)));
        BufferParameters sharp = new BufferParameters();
        sharp.setJoinStyle(BufferParameters.JOIN_MITRE);
        Geometry narrow = areas.difference(BufferOp.bufferOp(parts.get(0), depthM * GROWN_AGAIN, sharp));
        for (int i = 0; i < narrow.getNumGeometries(); i++) {
            Geometry piece = narrow.getGeometryN(i);
            if (piece instanceof Polygon && piece.getArea() > 0) {
                double halfM =
                        MaximumInscribedCircle.getRadiusLine(piece, ROUNDING_M).getLength();
                parts.add(piece.buffer(-MIDDLE * halfM));
            }
        }
        return union(parts);
    }

    /** The plane of all geometries here. */
    public LocalPlane plane() {
        return plane;
    }

    /** What is not to be entered, on the plane; polygons, maybe none. */
    public Geometry forbidden() {
        return forbidden;
    }

    /** Whether nothing is forbidden. */
    public boolean isOpen() {
        return forbidden.isEmpty();
    }

    /** Distance to forbidden areas in metres; zero inside, infinite where there are none. */
    public double clearanceM(GeoPoint point) {
        return isOpen() ? Double.POSITIVE_INFINITY : forbidden.distance(FACTORY.createPoint(coordinate(point)));
    }

    /** Distance of a way to forbidden areas in metres; infinite where there are none. */
    public double clearanceM(List<GeoPoint> way) {
        if (isOpen() || way.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        Coordinate[] stops = way.stream().map(this::coordinate).toArray(Coordinate[]::new);
        return forbidden.distance(stops.length == 1 ? FACTORY.createPoint(stops[0]) : FACTORY.createLineString(stops));
    }

    /** How far a point is inside what is forbidden, in metres: its distance to the edge; zero outside. */
    public double depthM(GeoPoint point) {
        Point place = FACTORY.createPoint(coordinate(point));
        return isOpen() || forbidden.distance(place) > 0
                ? 0
                : forbidden.getBoundary().distance(place);
    }

    /**
     * The nearest point at which a boat inside a forbidden area is outside and clear of it; the point itself for a boat outside.
     *
     * @param marginM distance to keep from forbidden areas, in metres
     */
    public GeoPoint outside(GeoPoint point, double marginM) {
        if (clearanceM(point) > 0) {
            return point;
        }
        Geometry rim = forbidden.buffer(marginM).getBoundary();
        return Areas.point(DistanceOp.nearestPoints(rim, FACTORY.createPoint(coordinate(point)))[0], plane);
    }

    /** The place of a way that is nearest to what is forbidden; where nothing is, its first point. */
    public GeoPoint nearest(List<GeoPoint> way) {
        if (isOpen() || way.size() < 2) {
            return way.get(0);
        }
        Coordinate[] stops = way.stream().map(this::coordinate).toArray(Coordinate[]::new);
        return Areas.point(DistanceOp.nearestPoints(FACTORY.createLineString(stops), forbidden)[0], plane);
    }

    /** Distance of the convex hull of some points to forbidden areas in metres; infinite where there are none. */
    public double clearanceBetweenM(List<GeoPoint> points) {
        if (isOpen() || points.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        Coordinate[] places = points.stream().map(this::coordinate).toArray(Coordinate[]::new);
        return forbidden.distance(FACTORY.createMultiPointFromCoords(places).convexHull());
    }

    /** Whether a way, or a point alone, stays in what is allowed, however far away it is. */
    public boolean allows(List<GeoPoint> way) {
        return clearanceM(way) > 0;
    }

    /** What of a polygon on the plane is allowed. */
    public Geometry allowed(Polygon polygon) {
        return isOpen() ? polygon : polygon.difference(forbidden);
    }

    private Coordinate coordinate(GeoPoint point) {
        return Areas.coordinate(point, plane);
    }
}
