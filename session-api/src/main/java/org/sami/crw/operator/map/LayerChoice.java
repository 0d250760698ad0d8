package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.LongFunction;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.markup.MarkedEvent;
import org.sami.crw.operator.map.LayerState.Reason;

/** Which layers are on: as a person says, else as the markup of events in force says, else from the start. For the owner's thread. */
public final class LayerChoice {
    private static final Set<ShownLayer> PATHS =
            Set.of(ShownLayer.PAST_PATHS, ShownLayer.CURRENT_PATHS, ShownLayer.FUTURE_PATHS);

    private final LongFunction<String> missions;
    private final Map<ShownLayer, Boolean> byHand = new EnumMap<>(ShownLayer.class);
    private final Map<SensorChannel, Visualization> dataByHand = new LinkedHashMap<>();
    private final Map<SensorChannel, Double> thresholds = new LinkedHashMap<>();

    /**
     * Layers as they are from the start.
     *
     * @param missions names a mission
     */
    public LayerChoice(LongFunction<String> missions) {
        this.missions = missions;
    }

    public void set(ShownLayer layer, Optional<Boolean> on) {
        on.ifPresentOrElse(is -> byHand.put(layer, is), () -> byHand.remove(layer));
    }

    public void showData(SensorChannel channel, Optional<Visualization> visualization) {
        visualization.ifPresentOrElse(how -> dataByHand.put(channel, how), () -> dataByHand.remove(channel));
    }

    public void threshold(SensorChannel channel, double value) {
        thresholds.put(channel, value);
    }

    /** The state of each layer. */
    public List<LayerState> states(Collection<MarkedEvent> events, Collection<String> allBoats) {
        List<LayerState> states = new ArrayList<>();
        for (ShownLayer layer : ShownLayer.values()) {
            states.add(state(layer, events, allBoats));
        }
        return states;
    }

    private LayerState state(ShownLayer layer, Collection<MarkedEvent> events, Collection<String> allBoats) {
        Boolean hand = byHand.get(layer);
        if (hand != null) {
            return new LayerState(layer, hand, Reason.HAND, "by hand", Set.of());
        }
        if (layer == ShownLayer.SENSOR_DATA && !dataByHand.isEmpty()) {
            return new LayerState(layer, true, Reason.HAND, "by hand", Set.of());
        }
        if (layer.isOnByDefault()) {
            return new LayerState(layer, true, Reason.DEFAULT, "", Set.of());
        }
        Set<String> why = new LinkedHashSet<>();
        Set<String> boats = new LinkedHashSet<>();
        boolean all = false;
        for (MarkedEvent event : events) {
            MapRelevance relevance = event.relevance(allBoats);
            if (layer == ShownLayer.SENSOR_DATA && relevance.information().isPresent()) {
                all = true;
                why.add(event.words(missions));
            } else if (relevance.boats().filter(shown -> asks(layer, shown)).isPresent()) {
                boats.addAll(relevance.boats().get().boats());
                why.add(event.words(missions));
            }
        }
        return why.isEmpty()
                ? new LayerState(layer, false, Reason.DEFAULT, "", Set.of())
                : new LayerState(layer, true, Reason.MARKUP, String.join(", ", why), all ? Set.of() : boats);
    }

    private static boolean asks(ShownLayer layer, MapRelevance.Boats boats) {
        if (PATHS.contains(layer)) {
            return boats.showPath();
        } else if (layer == ShownLayer.BOAT_STATE) {
            return boats.showDiagnostic();
        }
        return layer == ShownLayer.SENSOR_DATA && boats.showData();
    }

    /** The data that are to be drawn. Where the layer was switched on and nobody names a channel, it is the first one that boats measure. */
    public List<SensorFields.Request> requests(Collection<MarkedEvent> events, Collection<String> allBoats) {
        if (Boolean.FALSE.equals(byHand.get(ShownLayer.SENSOR_DATA))) {
            return List.of();
        }
        List<SensorFields.Request> requests = new ArrayList<>();
        dataByHand.forEach((channel, how) -> requests.add(
                new SensorFields.Request(channel.toString(), how, Set.of(), threshold(channel.toString()), "by hand")));
        for (MarkedEvent event : events) {
            MapRelevance relevance = event.relevance(allBoats);
            Optional<MapRelevance.Boats> boats = relevance.boats().filter(MapRelevance.Boats::showData);
            if (relevance.information().isPresent() || boats.isPresent()) {
                MapRelevance.Information information =
                        relevance.information().orElse(new MapRelevance.Information("", Visualization.HEATMAP));
                requests.add(new SensorFields.Request(
                        information.sensor(),
                        information.visualization(),
                        boats.map(shown -> Set.copyOf(shown.boats())).orElse(Set.of()),
                        threshold(information.sensor()),
                        event.words(missions)));
            }
        }
        if (requests.isEmpty() && byHand.containsKey(ShownLayer.SENSOR_DATA)) {
            requests.add(
                    new SensorFields.Request("", Visualization.HEATMAP, Set.of(), OptionalDouble.empty(), "by hand"));
        }
        return requests;
    }

    private OptionalDouble threshold(String word) {
        return thresholds.entrySet().stream()
                .filter(one -> one.getKey().isCalled(word))
                .mapToDouble(Map.Entry::getValue)
                .findFirst();
    }
}
