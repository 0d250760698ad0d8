package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.area.OperatingArea;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** The areas and places that variables of the project and of missions hold, and the operating area. For the owner's thread. */
public final class AreaVariables {
    private final Map<Long, Map<String, Value>> variables = new LinkedHashMap<>(); // Ids.NONE: of the project
    private Optional<Value> remembered = Optional.empty();

    public AreaVariables() {
        variables.put(Ids.NONE, new LinkedHashMap<>());
    }

    /** Forgets all. */
    public void clear() {
        variables.clear();
        variables.put(Ids.NONE, new LinkedHashMap<>());
        remembered = Optional.empty();
    }

    /** The project's variables are these now. Gives whether that may change something. */
    public void project(Map<String, Value> globals) {
        variables.put(Ids.NONE, geographic(globals));
    }

    /** A mission began, or is known, with these variables of its own. */
    public void mission(long mission, Map<String, Value> values) {
        variables.put(mission, geographic(values));
    }

    public void remembered(Optional<Value> fence) {
        remembered = fence;
    }

    /** Follows what a step changed. Gives whether something was. */
    public boolean apply(Input input, List<Effect> effects) {
        Optional<Value> fence = OperatingArea.remembered(input);
        boolean changed = fence.isPresent();
        if (changed) {
            remembered = fence;
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.VariableWritten written && isGeographic(written.value())) {
                variables
                        .computeIfAbsent(written.mission(), id -> new LinkedHashMap<>())
                        .put(written.variable(), written.value());
                changed = true;
            } else if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                changed |= variables.remove(ended.mission()) != null;
            }
        }
        return changed;
    }

    public OperatingArea operatingArea() {
        return OperatingArea.of(variables.getOrDefault(Ids.NONE, Map.of()), remembered);
    }

    public List<NamedArea> areas() {
        List<NamedArea> areas = new ArrayList<>();
        OperatingArea operating = operatingArea();
        variables.forEach((mission, values) -> values.forEach((name, value) -> {
            if (!(mission == Ids.NONE && name.equals(OperatingArea.FENCE))) {
                ShownLayer layer = name.equals(OperatingArea.NO_GO) ? ShownLayer.NO_GO : ShownLayer.AREAS;
                OperatingArea.areas(Optional.of(value))
                        .forEach(area -> areas.add(new NamedArea(layer, mission, name, area)));
            }
        }));
        operating
                .fence()
                .ifPresent(fence -> areas.add(new NamedArea(
                        ShownLayer.FENCE, Ids.NONE, operating.byHand() ? "fence" : OperatingArea.FENCE, fence)));
        return areas;
    }

    public List<ShownPlace> places() {
        List<ShownPlace> places = new ArrayList<>();
        variables.forEach((mission, values) -> values.forEach(
                (name, value) -> points(value).forEach(point -> places.add(new ShownPlace(mission, name, point)))));
        return places;
    }

    private static List<GeoPoint> points(Value value) {
        if (value instanceof GeoPoint point) {
            return List.of(point);
        }
        return value instanceof ListValue list
                ? list.items().stream()
                        .filter(GeoPoint.class::isInstance)
                        .map(GeoPoint.class::cast)
                        .toList()
                : List.of();
    }

    private static Map<String, Value> geographic(Map<String, Value> values) {
        Map<String, Value> found = new LinkedHashMap<>();
        values.forEach((name, value) -> {
            if (isGeographic(value)) {
                found.put(name, value);
            }
        });
        return found;
    }

    private static boolean isGeographic(Value value) {
        return value instanceof GeoArea
                || value instanceof GeoPoint
                || (value instanceof ListValue list && list.items().stream().allMatch(AreaVariables::isGeographic));
    }
}
