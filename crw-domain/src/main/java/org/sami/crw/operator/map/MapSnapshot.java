package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * What is to be drawn on the map at a moment. All that is known is here; {@link #layers} says what of it is to be seen.
 *
 * @param layers one state of each layer, in the order in which they are drawn
 * @param boats that have said where they are
 * @param tracks of boats, by boat
 * @param paths of boats, current and future, by boat and then in the order in which they are driven
 * @param waysHome of boats that are expected to come home by themselves, by boat
 * @param data what sensors measured, as far as it is shown
 * @param channels all that sensors have measured, for choosing
 * @param view the part that is to be seen; empty before anybody asked for one
 * @param heldBack the last automatic change that was not made, or is made later, and why; empty text for none
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
