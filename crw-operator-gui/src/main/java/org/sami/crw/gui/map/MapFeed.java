package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.boat.BoatWords;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.operator.boat.Age;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.operator.map.ShownBoat;
import org.sami.crw.operator.map.ShownLayer;
import org.sami.crw.operator.map.ShownPlace;
import org.sami.crw.operator.map.ShownTrack;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.field.FieldGrid;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.map.AreaLayer;
import org.sami.ui.map.ExpectedPath;
import org.sami.ui.map.ExpectedPathLayer;
import org.sami.ui.map.HeatLayer;
import org.sami.ui.map.HeatMap;
import org.sami.ui.map.MapLayers;
import org.sami.ui.map.PathLayer;
import org.sami.ui.map.PlannedPath;
import org.sami.ui.map.PointLayer;
import org.sami.ui.map.ShownArea;
import org.sami.ui.map.ShownVehicle;
import org.sami.ui.map.Track;
import org.sami.ui.map.TrackLayer;
import org.sami.ui.map.VehicleLayer;
import org.sami.ui.map.VehicleShape;

/** Puts a snapshot of the map's model into the layers of a map. The layers follow the model: what is off there has nothing here. */
final class MapFeed {
    private final OperatorContext context;
    private final HeatLayer data = new HeatLayer("data", "Sensor data");
    private final AreaLayer areas = new AreaLayer("areas", "Areas");
    private final TrackLayer tracks = new TrackLayer("tracks", "Past paths");
    private final PathLayer paths = new PathLayer("paths", "Paths");
    private final ExpectedPathLayer waysHome = new ExpectedPathLayer("ways-home", "Expected ways home");
    private final PointLayer places = new PointLayer("places", "Places");
    private final VehicleLayer boats;

    private final Map<String, Known> known = new HashMap<>();

    /** The points of the model that a track was made of. */
    private record Known(List<ShownTrack.Point> points, Track track) {}

    MapFeed(OperatorContext context, MapLayers layers) {
        this.context = context;
        boats = new VehicleLayer(
                "boats",
                context.say("Boats"),
                robot -> context.kindOf(robot) == RobotKind.COPTER ? VehicleShape.COPTER : VehicleShape.HULL);
        List.of(data, areas, tracks, paths, waysHome, places, boats).forEach(layers::add);
    }

    void show(MapSnapshot map) {
        data.show(map.data().stream()
                .filter(layer -> map.layer(ShownLayer.SENSOR_DATA).on())
                .findFirst()
                .map(MapFeed::heat));
        areas.show(map.areas().stream()
                .filter(area -> map.layer(area.layer()).on())
                .map(area -> new ShownArea(
                        area.layer().name() + "/" + area.mission() + "/" + area.name(),
                        area.name(),
                        area.area(),
                        kind(area.layer())))
                .toList());
        tracks.show(map.tracks().stream()
                .filter(track -> map.layer(ShownLayer.PAST_PATHS).shows(track.boat()))
                .map(this::track)
                .toList());
        Map<String, GeoPoint> at = new HashMap<>();
        map.boats().forEach(boat -> at.put(boat.boat(), boat.position()));
        paths.show(map.paths().stream()
                .filter(path -> map.layer(path.current() ? ShownLayer.CURRENT_PATHS : ShownLayer.FUTURE_PATHS)
                        .shows(path.boat()))
                .map(path -> new PlannedPath(
                        path.command(),
                        context.marks().of(path.boat()),
                        path.current() && path.visited() == 0
                                ? fromBoat(at.get(path.boat()), path.points())
                                : path.points(),
                        !path.current() ? 0 : Math.min(path.points().size(), Math.max(1, path.visited()))))
                .toList());
        waysHome.show(map.waysHome().stream()
                .filter(way -> map.layer(ShownLayer.WAYS_HOME).shows(way.boat()))
                .map(way -> new ExpectedPath(
                        way.boat() + "/home",
                        context.marks().of(way.boat()),
                        way.points(),
                        "expected way home of " + way.boat()))
                .toList());
        places.show(points(map.layer(ShownLayer.PLACES).on() ? map.places() : List.of()));
        boolean some = map.boats().stream().anyMatch(boat -> !boat.highlighted()); // who stands out among none does not
        boats.show(map.boats().stream()
                .filter(boat -> map.layer(ShownLayer.BOATS).shows(boat.boat()))
                .map(boat -> vehicle(
                        boat,
                        some && boat.highlighted(),
                        map.layer(ShownLayer.BOAT_STATE).shows(boat.boat())))
                .toList());
    }

    /** The points of a list are distinguished by their numbers; its first has the name as well. */
    static List<PointLayer.MapPoint> points(List<ShownPlace> places) {
        Map<String, Integer> counts = new HashMap<>();
        List<PointLayer.MapPoint> points = new ArrayList<>();
        for (ShownPlace place : places) {
            String variable = place.mission() + "/" + place.name();
            int number = counts.merge(variable, 1, Integer::sum);
            points.add(new PointLayer.MapPoint(
                    variable + "/" + number, number == 1 ? place.name() : String.valueOf(number), place.point()));
        }
        return points;
    }

    /** The first leg begins at the boat. */
    private static List<GeoPoint> fromBoat(@Nullable GeoPoint boat, List<GeoPoint> points) {
        if (boat == null) {
            return points;
        }
        List<GeoPoint> all = new ArrayList<>();
        all.add(boat);
        all.addAll(points);
        return all;
    }

    private static ShownArea.Kind kind(ShownLayer layer) {
        return switch (layer) {
            case NO_GO -> ShownArea.Kind.NO_GO;
            case FENCE -> ShownArea.Kind.FENCE;
            default -> ShownArea.Kind.WORK;
        };
    }

    /** A track that is as it was is not copied again: most are, ten times a second. */
    private Track track(ShownTrack now) {
        IdentityMark mark = context.marks().of(now.boat());
        Optional<Known> before = Optional.ofNullable(known.get(now.boat()))
                .filter(one ->
                        one.points() == now.points() && one.track().mark().equals(mark));
        if (before.isPresent()) {
            return before.get().track();
        }
        List<GeoPoint> points =
                now.points().stream().map(ShownTrack.Point::position).toList();
        Track track = new Track(now.boat(), mark, points);
        known.put(now.boat(), new Known(now.points(), track));
        return track;
    }

    private ShownVehicle vehicle(ShownBoat boat, boolean standsOut, boolean withState) {
        long ageMillis = ageMillis(boat);
        return new ShownVehicle(
                boat.boat(),
                withState ? boat.boat() + " · " + state(boat) : boat.boat(),
                context.marks().of(boat.boat()),
                boat.position(),
                boat.headingRad(),
                boat.courseRad(),
                boat.speedMps(),
                ageMillis / 1000.0,
                Age.words(ageMillis),
                context.boats().contains(boat.boat()) || standsOut);
    }

    /** Of a boat whose link is lost the age is that of the link, as in the lists; of another one that of its pose, which may be old though the link stands. */
    private long ageMillis(ShownBoat boat) {
        long now = context.nowMillis();
        OptionalLong silence = boat.link() == LinkState.LOST
                ? context.models().fleet().boat(boat.boat()).stream()
                        .flatMapToLong(known -> known.linkAgeMillis(now).stream())
                        .findFirst()
                : OptionalLong.empty();
        return silence.orElse(Math.max(0, now - boat.poseAtMillis()));
    }

    /** Its charge, if it has reported one, and its speed. */
    private static String state(ShownBoat boat) {
        String speed = boat.isCarried() ? BoatWords.drift(boat.speedMps()) : BoatWords.speed(boat.speedMps());
        return boat.batteryPercent().isPresent()
                ? String.format(
                        Locale.ROOT, "%.0f %% · %s", boat.batteryPercent().getAsDouble(), speed)
                : speed;
    }

    /** The grid counts its rows from the south, the map from the north. */
    private static HeatMap heat(SensorLayer layer) {
        FieldGrid grid = layer.grid();
        List<Double> values = new ArrayList<>();
        for (int row = grid.rows() - 1; row >= 0; row--) {
            for (int column = 0; column < grid.columns(); column++) {
                values.add(grid.value(column, row).orElse(Double.NaN));
            }
        }
        GeoPoint corner = grid.southWest();
        GeoBounds bounds = new GeoBounds(
                corner.latDeg(),
                corner.lonDeg(),
                corner.latDeg() + grid.rows() * grid.latStepDeg(),
                corner.lonDeg() + grid.columns() * grid.lonStepDeg());
        double most = grid.greatest() > grid.least() ? grid.greatest() : grid.least() + 1;
        return new HeatMap(
                layer.channel().toString(),
                layer.channel().unit(),
                bounds,
                grid.columns(),
                grid.rows(),
                values,
                grid.least(),
                most,
                layer.visualization() == Visualization.THRESHOLD
                        ? OptionalDouble.of(layer.threshold())
                        : OptionalDouble.empty());
    }

    /** The box around boats and places, for the first look. */
    static Optional<GeoBounds> bounds(MapSnapshot map) {
        List<GeoPoint> points = new ArrayList<>();
        map.boats().forEach(boat -> points.add(boat.position()));
        map.places().forEach(place -> points.add(place.point()));
        return GeoBounds.of(points);
    }
}
