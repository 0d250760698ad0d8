package org.sami.crw.sim.run.incident;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.session.SessionListener;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** The locations that the operator gave first, and which of them boats have reported as visited. For the run's thread. */
final class LocationsToVisit implements SessionListener {
    private final Set<GeoPoint> visited = new HashSet<>();
    private final List<GeoPoint> all = new ArrayList<>();

    @Override
    public void onPassed(String boat, List<GeoPoint> points, long atMillis) {
        visited.addAll(points);
    }

    /** The value that the operator gives: all at first, afterwards the unvisited ones. */
    Value given(ListValue drawn) {
        if (all.isEmpty()) {
            drawn.items().forEach(item -> all.add((GeoPoint) item));
        }
        return new ListValue(List.copyOf(unvisited()));
    }

    List<GeoPoint> unvisited() {
        return all.stream().filter(point -> !visited.contains(point)).toList();
    }
}
