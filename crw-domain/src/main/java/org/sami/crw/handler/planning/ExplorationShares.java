package org.sami.crw.handler.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.handler.motion.PathProgress;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** How a mission remembers the paths of the boats that explore an area: by boat, under a key that area and spacing give. */
public final class ExplorationShares {
    private ExplorationShares() {}

    /** Where in a mission's memory they are. */
    static String key(GeoArea area, double spacingM) {
        List<GeoPoint> points = new ArrayList<>(area.outline());
        area.holes().forEach(points::addAll);
        return "explore/" + PathProgress.key(Double.toString(spacingM), new GeoPath(points));
    }

    static Input remember(long mission, String key, Map<String, GeoPath> shares) {
        return new Input.Remember(mission, key, ProxyMaps.toValue(shares));
    }

    /** What a mission remembers; nothing where the area is not divided yet. */
    static Map<String, GeoPath> remembered(long mission, String key, EngineView view) {
        return view.memory(mission, key)
                .map(value -> ProxyMaps.read(value, GeoPath.class))
                .orElseGet(LinkedHashMap::new);
    }

    /** The paths that an input has a mission remember for an area; empty where it is about something else. */
    public static Optional<Map<String, GeoPath>> of(Input input, GeoArea area, double spacingM) {
        return input instanceof Input.Remember remember && remember.key().equals(key(area, spacingM))
                ? Optional.of(ProxyMaps.read(remember.value(), GeoPath.class))
                : Optional.empty();
    }
}
