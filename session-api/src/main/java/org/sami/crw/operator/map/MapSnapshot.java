package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * The contents of the map at a moment. It holds everything known; {@link #layers} says which of it is shown.
 *
 * @param layers one state of each layer, in drawing order
 * @param boats boats with a known position
 * @param tracks tracks of boats, by boat
 * @param paths present and later paths, by boat and then in driving order
 * @param waysHome expected ways home of boats that return by themselves, by boat
 * @param data the shown measurements
 * @param channels all measured channels, for choosing
 * @param view the part to show; empty before the first request
 * @param heldBack the last automatic change that was suppressed or delayed, and why; empty text for none
 */
public record MapSnapshot(
        List<LayerState> layers,
        List<ShownBoat> boats,
        List<ShownTrack> tracks,
        List<ShownPath> paths,
        List<ShownWayHome> waysHome,
        List<NamedArea> areas,
        List<ShownPlace> places,
        List<SensorLayer> data,
        List<SensorChannel> channels,
        Optional<ShownPart> view,
        String heldBack) {
    /** An empty map, before the first look. */
    public static final MapSnapshot EMPTY = new MapSnapshot(
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            Optional.empty(),
            "");

    public MapSnapshot {
        layers = List.copyOf(layers);
        boats = List.copyOf(boats);
        tracks = List.copyOf(tracks);
        paths = List.copyOf(paths);
        waysHome = List.copyOf(waysHome);
        areas = List.copyOf(areas);
        places = List.copyOf(places);
        data = List.copyOf(data);
        channels = List.copyOf(channels);
        Objects.requireNonNull(view, "view");
        Objects.requireNonNull(heldBack, "heldBack");
    }

    /** How a layer stands; off before the first look. */
    public LayerState layer(ShownLayer layer) {
        return layers.stream()
                .filter(state -> state.layer() == layer)
                .findFirst()
                .orElse(new LayerState(layer, false, LayerState.Reason.DEFAULT, "", Set.of()));
    }
}
