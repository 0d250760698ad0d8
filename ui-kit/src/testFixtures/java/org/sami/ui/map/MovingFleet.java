package org.sami.ui.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;

/** Vehicles on a map that go on with {@link #move}, each with its track and the path that it follows; the same each time. */
public final class MovingFleet {
    private static final double MOVE_M = 0.15; // at 1.5 m/s, ten times a second
    private static final int MOVES_A_POINT = 7; // a track has a point a metre
    private static final double POINT_M = 0.3;
    private static final String[] NAMES = {
        "anna", "bert", "carl", "dora", "emil", "frida", "gustav", "hanna", "ida", "jan", "karl", "lena", "moritz",
        "nora", "otto", "paula", "quirin", "rosa", "sven", "tilda"
    };

    private final Random random = new Random(7);
    private final List<Vehicle> vehicles = new ArrayList<>();
    private final MapView map = new MapView();
    private final TrackLayer tracks;
    private final PathLayer paths;
    private final VehicleLayer layer;
    private int moves;

    private static final class Vehicle {
        private double eastM;
        private double northM;
        private double headingRad;
        private final List<GeoPoint> track = new ArrayList<>();
    }

    /** So many vehicles, each with so many points where it has been. */
    public MovingFleet(int vehicles, int trackPoints) {
        MapScenes.addGround(map);
        tracks = map.layers().add(new TrackLayer("tracks", "Tracks"));
        paths = map.layers().add(new PathLayer("paths", "Paths"));
        layer = map.layers().add(new VehicleLayer("vehicles", "Vehicles"));
        for (int i = 0; i < vehicles; i++) {
            this.vehicles.add(vehicle(trackPoints));
        }
        show();
    }

    private Vehicle vehicle(int trackPoints) {
        Vehicle vehicle = new Vehicle();
        vehicle.headingRad = random.nextDouble() * 2 * Math.PI;
        vehicle.eastM = random.nextDouble() * 300 - 150;
        vehicle.northM = random.nextDouble() * 300 - 150;
        for (int k = 0; k < trackPoints; k++) {
            vehicle.headingRad += random.nextGaussian() * 0.06;
            ahead(vehicle, POINT_M);
            vehicle.track.add(MapScenes.at(vehicle.eastM, vehicle.northM));
        }
        return vehicle;
    }

    private static void ahead(Vehicle vehicle, double metres) {
        vehicle.eastM += Math.sin(vehicle.headingRad) * metres;
        vehicle.northM += Math.cos(vehicle.headingRad) * metres;
    }

    /** The map that they are on. */
    public MapView map() {
        return map;
    }

    /** All go on for a tenth of a second; every seventh time their tracks grow by a point. */
    public void move() {
        moves++;
        for (Vehicle vehicle : vehicles) {
            vehicle.headingRad += random.nextGaussian() * 0.02;
            ahead(vehicle, MOVE_M);
            if (moves % MOVES_A_POINT == 0) {
                vehicle.track.add(MapScenes.at(vehicle.eastM, vehicle.northM));
            }
        }
        show();
    }

    private void show() {
        List<ShownVehicle> shown = new ArrayList<>();
        List<Track> past = new ArrayList<>();
        List<PlannedPath> planned = new ArrayList<>();
        for (int i = 0; i < vehicles.size(); i++) {
            Vehicle vehicle = vehicles.get(i);
            double x = vehicle.eastM;
            double y = vehicle.northM;
            GeoPoint here = MapScenes.at(x, y);
            IdentityMark mark = new IdentityMark(i);
            String id = "proxy-" + i;
            past.add(new Track(id, mark, vehicle.track));
            planned.add(new PlannedPath(
                    id,
                    mark,
                    List.of(
                            vehicle.track.get(vehicle.track.size() / 2),
                            here,
                            MapScenes.at(x + 40, y),
                            MapScenes.at(x + 40, y + 30),
                            MapScenes.at(x, y + 30)),
                    2));
            shown.add(new ShownVehicle(
                    id,
                    NAMES[i % NAMES.length],
                    mark,
                    here,
                    vehicle.headingRad,
                    vehicle.headingRad,
                    i % 4 * 0.5,
                    i == 3 ? 12 : 0.3,
                    i == 1));
        }
        tracks.show(past);
        paths.show(planned);
        layer.show(shown);
    }
}
