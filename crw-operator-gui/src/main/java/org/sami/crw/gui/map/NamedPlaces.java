package org.sami.crw.gui.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.map.MapView;
import org.sami.ui.map.PointLayer;

/** Marks on a map the places that a text names. */
final class NamedPlaces {
    private final PointLayer layer;

    /**
     * Adds a layer to a map, above those that it has.
     *
     * @param what names the places; begins the layer's id
     */
    NamedPlaces(MapView map, String what) {
        layer = map.layers().add(new PointLayer(what + "-places", "Places that a " + what + " names"));
    }

    /**
     * Marks these places, and no others.
     *
     * @return the ids of their marks
     */
    Set<String> show(List<GeoPoint> places) {
        List<PointLayer.MapPoint> points = new ArrayList<>();
        for (GeoPoint place : places) {
            String name = places.size() == 1 ? "here" : "here, " + (points.size() + 1);
            points.add(new PointLayer.MapPoint(layer.id() + "-" + points.size(), name, place));
        }
        layer.show(points);
        return points.stream().map(PointLayer.MapPoint::id).collect(Collectors.toSet());
    }
}
