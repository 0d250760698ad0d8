package org.sami.ui.value;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;
import org.sami.ui.map.AreaLayer;
import org.sami.ui.map.MapView;
import org.sami.ui.map.PathLayer;
import org.sami.ui.map.PlannedPath;
import org.sami.ui.map.PointLayer;
import org.sami.ui.map.ShownArea;

/** Draws on a map what of values has a place, in layers of its own: points, areas, and paths in the colours of their robots. */
public final class PlacesOnMap {
    private static final IdentityMark NOBODY = new IdentityMark(0);

    private final Function<String, IdentityMark> marks;
    private RobotWays ways;
    private long shows;
    private final AreaLayer areas;
    private final PathLayer paths;
    private final PointLayer points;
    private final List<ShownArea> shownAreas = new ArrayList<>();
    private final List<PlannedPath> shownPaths = new ArrayList<>();
    private final List<PointLayer.MapPoint> shownPoints = new ArrayList<>();
    private final Set<String> ids = new LinkedHashSet<>();
    private final String id;
    private final MapView map;

    /**
     * Adds the layers to a map, above those that it has.
     *
     * @param id begins the ids of the layers and of what is in them
     * @param marks of robots
     */
    public PlacesOnMap(MapView map, String id, Function<String, IdentityMark> marks) {
        this(map, id, marks, RobotWays.AS_GIVEN);
    }

    /**
     * The same, with paths as their robots would go along them.
     *
     * @param ways of robots
     */
    public PlacesOnMap(MapView map, String id, Function<String, IdentityMark> marks, RobotWays ways) {
        this.id = id;
        this.map = map;
        this.marks = marks;
        this.ways = ways;
        areas = map.layers().add(new AreaLayer(id + "-areas", "Areas of " + id));
        paths = map.layers().add(new PathLayer(id + "-paths", "Paths of " + id));
        points = map.layers().add(new PointLayer(id + "-points", "Points of " + id));
    }

    /** The same with paths as their robots would go along them. */
    public void show(List<Value> values, RobotWays by) {
        ways = by;
        show(values);
    }

    /** Shows the places of these values, and no others. */
    public void show(List<Value> values) {
        shows++;
        List.of(shownAreas, shownPaths, shownPoints).forEach(List::clear);
        ids.clear();
        values.forEach(value -> draw(Optional.empty(), value));
        areas.show(List.copyOf(shownAreas));
        paths.show(List.copyOf(shownPaths));
        points.show(List.copyOf(shownPoints));
    }

    /** Whether all of it lies in the part of the world that the map shows; true where there is nothing. */
    public boolean isInSight() {
        return shownPoints.stream().allMatch(point -> map.frame().isShown(point.at()))
                && shownPaths.stream().flatMap(path -> path.points().stream()).allMatch(map.frame()::isShown)
                && shownAreas.stream()
                        .flatMap(area -> area.area().outline().stream())
                        .allMatch(map.frame()::isShown);
    }

    /** Names what is drawn, and the robots that are named, to highlight them. */
    public Set<String> ids() {
        return Collections.unmodifiableSet(ids);
    }

    private void draw(Optional<String> robot, Value value) {
        if (value instanceof GeoPoint point) {
            shownPoints.add(new PointLayer.MapPoint(newId(), String.valueOf(shownPoints.size() + 1), point));
        } else if (value instanceof GeoPath path) {
            draw(robot, path);
        } else if (value instanceof GeoArea area) {
            shownAreas.add(new ShownArea(newId(), "", area, ShownArea.Kind.WORK));
        } else if (value instanceof ProxyValue proxy) {
            ids.add(proxy.proxy());
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> draw(robot, item));
        } else if (value instanceof RecordValue fields) {
            fields.fields().values().forEach(part -> draw(robot, part));
        } else if (value instanceof MapValue map) {
            map.entries().forEach((key, one) -> drawEntry(robot, key, one));
        }
    }

    private void draw(Optional<String> robot, GeoPath path) {
        PlannedPath given = new PlannedPath(newId(), robot.map(marks).orElse(NOBODY), path.points(), 0);
        int index = shownPaths.size();
        long show = shows;
        shownPaths.add(given);
        robot.ifPresent(one -> ways.find(one, path, way -> {
            if (show == shows) {
                shownPaths.set(index, new PlannedPath(given.id(), given.mark(), way, 0));
                paths.show(List.copyOf(shownPaths));
            }
        }));
    }

    private void drawEntry(Optional<String> robot, Value key, Value value) {
        if (key instanceof ProxyValue proxy) {
            ids.add(proxy.proxy());
            draw(Optional.of(proxy.proxy()), value);
        } else {
            draw(robot, value);
        }
    }

    private String newId() {
        String made = id + "-" + (shownAreas.size() + shownPaths.size() + shownPoints.size() + 1);
        ids.add(made);
        return made;
    }
}
