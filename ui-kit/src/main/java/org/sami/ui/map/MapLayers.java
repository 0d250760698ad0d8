package org.sami.ui.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;

/** The layers of a map, from the lowest to the topmost. */
public final class MapLayers {
    private final List<MapLayer> layers = new ArrayList<>();
    private final Runnable changed;

    MapLayers(Runnable changed) {
        this.changed = changed;
    }

    /** Puts a layer on top, and hands it back. */
    public <L extends MapLayer> L add(L layer) {
        if (find(layer.id()).isPresent()) {
            throw new IllegalArgumentException("The map has a layer '" + layer.id() + "' already");
        }
        layers.add(layer);
        layer.listen(changed);
        changed.run();
        return layer;
    }

    /** Puts a layer below all others, and hands it back. */
    public <L extends MapLayer> L addBelow(L layer) {
        add(layer);
        layers.remove(layer);
        layers.add(0, layer);
        return layer;
    }

    /** Takes a layer away; does nothing where it is not there. */
    public void remove(MapLayer layer) {
        if (layers.remove(layer)) {
            layer.listen(() -> {});
            changed.run();
        }
    }

    /** All of them. */
    public List<MapLayer> all() {
        return List.copyOf(layers);
    }

    /** The layer of an id. */
    public Optional<MapLayer> find(String id) {
        return layers.stream().filter(layer -> layer.id().equals(id)).findFirst();
    }

    /** Those that are shown. */
    List<MapLayer> visible() {
        return layers.stream().filter(MapLayer::isVisible).toList();
    }

    /** Changes when what stays of the layers that are shown is to be painted again. */
    Object stillRevision() {
        return layers.stream()
                .filter(MapLayer::isVisible)
                .map(layer -> Map.entry(layer.id(), layer.stillRevision()))
                .toList();
    }

    /** The box around all that is shown. */
    Optional<GeoBounds> bounds() {
        return visible().stream().flatMap(layer -> layer.bounds().stream()).reduce(GeoBounds::with);
    }

    Optional<String> itemAt(MapFrame frame, double px, double py) {
        return first(layer -> layer.itemAt(frame, px, py));
    }

    Optional<String> textAt(MapFrame frame, double px, double py) {
        return first(layer -> layer.textAt(frame, px, py));
    }

    /** Of the topmost layer that has an answer. */
    private Optional<String> first(Function<MapLayer, Optional<String>> question) {
        List<MapLayer> shown = visible();
        for (int i = shown.size() - 1; i >= 0; i--) {
            Optional<String> answer = question.apply(shown.get(i));
            if (answer.isPresent()) {
                return answer;
            }
        }
        return Optional.empty();
    }

    Snapping snapping() {
        Snapping snapping = new Snapping();
        visible().forEach(layer -> layer.offer(snapping));
        return snapping;
    }
}
