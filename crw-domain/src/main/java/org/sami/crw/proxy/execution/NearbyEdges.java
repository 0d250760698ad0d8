package org.sami.crw.proxy.execution;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.LineSegment;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.util.LinearComponentExtracter;
import org.locationtech.jts.index.strtree.STRtree;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** Finds the edges of what a boat is not to enter that are near it, so that it keeps off them while it gives way. For one thread. */
public final class NearbyEdges {
    /** How far edges matter, in metres: farther than a boat gets before the next edges reach it. */
    static final double REACH_M = 30;

    /** How far a boat may go until edges are looked for again, in metres. */
    private static final double MOVED_M = 5;

    private final Water water;
    private final STRtree edges = new STRtree();
    private Coordinate lookedAt = new Coordinate(Double.NaN, Double.NaN);
    private Optional<NoGoEdges> found = Optional.empty();

    /** Those of the water in which the boat may go. */
    NearbyEdges(Water water) {
        this.water = water;
        for (Object line : LinearComponentExtracter.getLines(water.forbidden().norm())) { // inside to starboard
            Coordinate[] places = ((LineString) line).getCoordinates();
            for (int i = 1; i < places.length; i++) {
                edges.insert(new Envelope(places[i - 1], places[i]), new LineSegment(places[i - 1], places[i]));
            }
        }
        edges.build();
    }

    /** Those near a boat that is there, and how far it keeps off them; empty where none are near. */
    public Optional<NoGoEdges> near(GeoPoint boat) {
        Coordinate at = Areas.coordinate(boat, water.plane());
        if (!(at.distance(lookedAt) <= MOVED_M)) {
            lookedAt = at;
            found = find(at);
        }
        return found;
    }

    private Optional<NoGoEdges> find(Coordinate at) {
        Envelope box = new Envelope(at);
        box.expandBy(REACH_M + MOVED_M);
        List<LineSegment> near = new ArrayList<>();
        for (Object edge : edges.query(box)) {
            cut((LineSegment) edge, at).ifPresent(near::add);
        }
        near.sort(Comparator.comparingDouble(edge -> edge.distance(at)));
        List<NoGoEdge> rows =
                near.stream().limit(NoGoEdges.MOST_EDGES).map(this::row).toList();
        return rows.isEmpty()
                ? Optional.empty()
                : Optional.of(new NoGoEdges(water.margin().pathM(), rows));
    }

    /** The part of an edge that lies in the circle around the boat: edges may be as long as the world. */
    private static Optional<LineSegment> cut(LineSegment edge, Coordinate at) {
        double lengthM = edge.getLength();
        double awayM = edge.distancePerpendicular(at);
        double halfM = Math.sqrt(Math.max(0, (REACH_M + MOVED_M) * (REACH_M + MOVED_M) - awayM * awayM));
        double nearestM = edge.projectionFactor(at) * lengthM;
        double fromM = Math.max(0, nearestM - halfM);
        double toM = Math.min(lengthM, nearestM + halfM);
        return halfM > 0 && fromM < toM
                ? Optional.of(new LineSegment(edge.pointAlong(fromM / lengthM), edge.pointAlong(toM / lengthM)))
                : Optional.empty();
    }

    private NoGoEdge row(LineSegment edge) {
        GeoPoint from = Areas.point(edge.p0, water.plane());
        GeoPoint to = Areas.point(edge.p1, water.plane());
        return new NoGoEdge(from.latDeg(), from.lonDeg(), to.latDeg(), to.lonDeg());
    }
}
