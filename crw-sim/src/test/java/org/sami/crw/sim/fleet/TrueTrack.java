package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LineString;
import org.locationtech.jts.geom.Polygon;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Where a hull truly was while it drove a path, and what that line covers, enters and keeps to. */
final class TrueTrack {
    private static final double STEP_S = 0.2;
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final LocalFrame frame;
    private final LineString line;
    private final boolean completed;

    private TrueTrack(LocalFrame frame, List<Coordinate> places, boolean completed) {
        this.frame = frame;
        line = FACTORY.createLineString(places.toArray(Coordinate[]::new));
        this.completed = completed;
    }

    /** Has the first boat of a world drive a path, and watches it until it has arrived or so many seconds are over. */
    static TrueTrack of(SimulatedTestWorld world, List<GeoPoint> path, double seconds) {
        return of(world, FollowPath.of("way", 1, 1, path, Priority.MEDIUM), seconds, 0, List.of());
    }

    /** The same for a command, in whose midst the boat gets another after so many seconds. */
    static TrueTrack of(
            SimulatedTestWorld world, FollowPath path, double seconds, double afterSeconds, BoatCommand other) {
        return of(world, path, seconds, afterSeconds, List.of(other));
    }

    private static TrueTrack of(
            SimulatedTestWorld world, FollowPath path, double seconds, double afterSeconds, List<BoatCommand> others) {
        world.proxy().commands().submit(path);
        String completed = "completed " + path.commandId();
        List<Coordinate> places = new ArrayList<>();
        boolean given = false;
        for (double t = 0; t < seconds && !world.reports().contains(completed); t += STEP_S) {
            if (!given && t >= afterSeconds) {
                given = true;
                others.forEach(world.proxy().commands()::submit);
            }
            places.add(new Coordinate(world.hull().eastM(), world.hull().northM()));
            world.run(STEP_S);
        }
        return new TrueTrack(world.fleet.frame(), places, world.reports().contains(completed));
    }

    /** Watches the first boat of a world, which does what it was told before, until something is so or the seconds are over. */
    static TrueTrack until(SimulatedTestWorld world, double seconds, BooleanSupplier over) {
        List<Coordinate> places = new ArrayList<>();
        for (double t = 0; t < seconds && !over.getAsBoolean(); t += STEP_S) {
            places.add(new Coordinate(world.hull().eastM(), world.hull().northM()));
            world.run(STEP_S);
        }
        return new TrueTrack(world.fleet.frame(), places, over.getAsBoolean());
    }

    boolean isCompleted() {
        return completed;
    }

    /** The part of an area, 0 to 1, to which the track comes as near as half the spacing. */
    double covered(GeoArea area, double spacingM) {
        Polygon polygon = polygon(area);
        return polygon.intersection(line.buffer(spacingM / 2, 32)).getArea() / polygon.getArea();
    }

    /** How far the track comes into the areas: the distance to their edge of its point deepest inside, in metres; zero outside. */
    double deepestInM(List<GeoArea> areas) {
        double deepestM = 0;
        for (GeoArea area : areas) {
            Polygon polygon = polygon(area);
            for (Coordinate place : line.intersection(polygon).getCoordinates()) {
                deepestM = Math.max(deepestM, polygon.getBoundary().distance(FACTORY.createPoint(place)));
            }
        }
        return deepestM;
    }

    /** How near the track comes to the areas, in metres. */
    double nearestM(List<GeoArea> areas) {
        return areas.stream()
                .mapToDouble(area -> polygon(area).distance(line))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** Distance of a point to the track, in metres. */
    double distanceM(GeoPoint point) {
        return line.distance(FACTORY.createPoint(place(point)));
    }

    /** How far the track gets from a path at most, in metres. */
    double farthestFromM(List<GeoPoint> path) {
        Geometry wanted =
                FACTORY.createLineString(path.stream().map(this::place).toArray(Coordinate[]::new));
        double farthestM = 0;
        for (Coordinate place : line.getCoordinates()) {
            farthestM = Math.max(farthestM, wanted.distance(FACTORY.createPoint(place)));
        }
        return farthestM;
    }

    private Polygon polygon(GeoArea area) {
        Polygon shell = FACTORY.createPolygon(ring(area.outline()));
        return (Polygon) area.holes().stream()
                .map(hole -> (Geometry) FACTORY.createPolygon(ring(hole)))
                .reduce(shell, Geometry::difference);
    }

    private Coordinate[] ring(List<GeoPoint> points) {
        List<Coordinate> ring = new ArrayList<>(points.stream().map(this::place).toList());
        ring.add(ring.get(0).copy());
        return ring.toArray(Coordinate[]::new);
    }

    private Coordinate place(GeoPoint point) {
        return new Coordinate(
                frame.eastM(point.latDeg(), point.lonDeg()), frame.northM(point.latDeg(), point.lonDeg()));
    }
}
