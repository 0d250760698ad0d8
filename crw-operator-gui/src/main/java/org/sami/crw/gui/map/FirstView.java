package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.MapView;

/**
 * Shows boats and areas as large as they fit until the operator moves the map: at first, when a boat or an area comes or goes, and when the
 * map's size changes. Boats that move leave the map where it is, as long as they stay in sight.
 */
final class FirstView {
    private final MapView view;
    private Optional<MapFrame> left = Optional.empty();
    private Set<String> shown = Set.of();
    private final BooleanSupplier free;
    private boolean over;

    /**
     * Shows nothing yet.
     *
     * @param free whether the map may follow boats that leave it: while somebody draws on it, it stays
     */
    FirstView(MapView view, BooleanSupplier free) {
        this.view = view;
        this.free = free;
    }

    /** Looks at what there is now. */
    void look(MapSnapshot now) {
        MapFrame frame = view.frame();
        if (over || bounds(now).isEmpty() || frame.width() == 0 || frame.height() == 0) {
            return;
        }
        if (left.isPresent() && !isSamePart(left.get(), frame)) {
            over = true; // somebody moved it
            return;
        }
        Set<String> things = new HashSet<>();
        now.boats().forEach(boat -> things.add(boat.boat()));
        now.areas().forEach(area -> things.add(area.mission() + "/" + area.name()));
        boolean sameSize = left.filter(before -> before.width() == frame.width() && before.height() == frame.height())
                .isPresent();
        boolean lost = now.boats().stream().anyMatch(boat -> !frame.isShown(boat.position()));
        if (!sameSize || !things.equals(shown) || (lost && free.getAsBoolean())) {
            shown = things;
            bounds(now).ifPresent(view::fit);
            left = Optional.of(view.frame());
        }
    }

    /** The program has moved the map: that is no reason to leave it to the operator. */
    void moved(Runnable move) {
        move.run();
        if (!over && left.isPresent()) {
            left = Optional.of(view.frame());
        }
    }

    /** Whether nobody has moved it: a map that becomes larger or smaller fits itself again, at another scale. */
    private static boolean isSamePart(MapFrame one, MapFrame other) {
        double pixel = 1 / one.worldPx();
        boolean sameSize = one.width() == other.width() && one.height() == other.height();
        return (one.worldPx() == other.worldPx() || !sameSize)
                && Math.abs(one.centreX() - other.centreX()) < pixel
                && Math.abs(one.centreY() - other.centreY()) < pixel;
    }

    /** The box around boats and areas; around boats and places where there is no area. */
    static Optional<GeoBounds> bounds(MapSnapshot map) {
        List<GeoPoint> points = new ArrayList<>();
        map.boats().forEach(boat -> points.add(boat.position()));
        map.areas().forEach(area -> points.addAll(area.area().outline()));
        if (map.areas().isEmpty()) {
            map.places().forEach(place -> points.add(place.point()));
        }
        return GeoBounds.of(points);
    }
}
