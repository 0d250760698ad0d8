package org.sami.dreamm.context;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.palette.IdentityMark;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapListener;
import org.sami.ui.map.MapView;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.PlacesOnMap;

/**
 * Maps that open where the project's places are, with the areas, paths and points of its variables; where it has none, where the author looked
 * last. On the event thread.
 */
public final class ProjectMaps implements MapMaker {
    private final ProjectDocument document;
    private Optional<GeoBounds> last = Optional.empty();
    private Consumer<String> keep = text -> {};
    private int height = MapMaker.PLAIN.height();

    ProjectMaps(ProjectDocument document) {
        this.document = Objects.requireNonNull(document, "document");
    }

    /**
     * Remembers from now on where the author looked last, over the end of the program.
     *
     * @param kept what was kept; empty text, or one that is none, where nothing was
     * @param keep keeps it
     */
    public void remember(String kept, Consumer<String> keep) {
        this.keep = Objects.requireNonNull(keep, "keep");
        last = read(kept);
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public void keepHeight(int now) {
        height = now;
    }

    private static Optional<GeoBounds> read(String kept) {
        String[] parts = kept.split(" ", -1);
        if (parts.length != 4) {
            return Optional.empty();
        }
        try {
            return Optional.of(new GeoBounds(
                    Double.parseDouble(parts[0]),
                    Double.parseDouble(parts[1]),
                    Double.parseDouble(parts[2]),
                    Double.parseDouble(parts[3])));
        } catch (IllegalArgumentException e) { // settings of another version: the map opens as without them
            return Optional.empty();
        }
    }

    @Override
    public MapView make() {
        MapView map = new MapView();
        List<Value> shown = ProjectValues.ofVariables(document.project());
        new PlacesOnMap(map, "project", robot -> new IdentityMark(0)).show(shown);
        bounds(shown)
                .or(() -> bounds(ProjectValues.of(document.project())))
                .or(() -> last)
                .ifPresent(map::fit);
        map.addMapListener(new MapListener() {
            @Override
            public void moved() {
                if (map.canvas().getWidth() > 0) {
                    looked(map.frame());
                }
            }
        });
        return map;
    }

    private void looked(MapFrame frame) {
        GeoPoint northWest = frame.point(0, 0);
        GeoPoint southEast = frame.point(frame.width(), frame.height());
        if (southEast.latDeg() <= northWest.latDeg() && northWest.lonDeg() <= southEast.lonDeg()) {
            last = Optional.of(
                    new GeoBounds(southEast.latDeg(), northWest.lonDeg(), northWest.latDeg(), southEast.lonDeg()));
        }
    }

    /** Keeps where the author looked last; to be called once, when the window ends. */
    void keepLast() {
        last.map(box -> String.format(
                        Locale.ROOT,
                        "%.6f %.6f %.6f %.6f",
                        box.southDeg(),
                        box.westDeg(),
                        box.northDeg(),
                        box.eastDeg()))
                .ifPresent(keep);
    }

    private static Optional<GeoBounds> bounds(List<Value> values) {
        List<GeoPoint> points = new ArrayList<>();
        values.forEach(value -> add(value, points));
        return GeoBounds.of(points);
    }

    private static void add(Value value, List<GeoPoint> points) {
        if (value instanceof GeoPoint point) {
            points.add(point);
        } else if (value instanceof GeoPath path) {
            points.addAll(path.points());
        } else if (value instanceof GeoArea area) {
            points.addAll(area.outline());
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> add(item, points));
        } else if (value instanceof RecordValue fields) {
            fields.fields().values().forEach(part -> add(part, points));
        } else if (value instanceof MapValue map) {
            map.entries().values().forEach(one -> add(one, points));
        }
    }
}
