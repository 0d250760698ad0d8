package org.sami.crw.service.allocation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

/** The auction of thesis 7.0.3 word by word: every bid builds its whole path again. */
final class AuctionByTheThesis {
    private final Map<String, GeoPoint> boats;
    private final List<GeoPoint> locations;
    private final LocalPlane plane;
    private final Map<String, List<GeoPoint>> won = new LinkedHashMap<>();

    AuctionByTheThesis(Map<String, GeoPoint> boats, List<GeoPoint> locations) {
        this.boats = boats;
        this.locations = locations;
        plane = new LocalPlane(boats.values().iterator().next());
        boats.keySet().forEach(boat -> won.put(boat, new ArrayList<>()));
    }

    Map<String, List<GeoPoint>> paths() {
        for (GeoPoint location : locations) {
            String winner = null;
            double best = Double.MAX_VALUE;
            for (String boat : won.keySet()) {
                List<GeoPoint> with = new ArrayList<>(won.get(boat));
                with.add(location);
                double bid = length(boats.get(boat), path(boats.get(boat), with));
                if (bid < best) {
                    best = bid;
                    winner = boat;
                }
            }
            won.get(winner).add(location);
        }
        Map<String, List<GeoPoint>> paths = new LinkedHashMap<>();
        won.forEach((boat, locations) -> paths.put(boat, path(boats.get(boat), locations)));
        return paths;
    }

    private List<GeoPoint> path(GeoPoint start, List<GeoPoint> locations) {
        List<GeoPoint> left = new ArrayList<>(locations);
        List<GeoPoint> path = new ArrayList<>();
        GeoPoint last = start;
        while (!left.isEmpty()) {
            GeoPoint nearest = left.get(0);
            for (GeoPoint candidate : left) {
                if (distance(last, candidate) < distance(last, nearest)) {
                    nearest = candidate;
                }
            }
            left.remove(nearest);
            path.add(nearest);
            last = nearest;
        }
        return path;
    }

    private double length(GeoPoint start, List<GeoPoint> path) {
        double length = 0;
        GeoPoint last = start;
        for (GeoPoint point : path) {
            length += distance(last, point);
            last = point;
        }
        return length;
    }

    private double distance(GeoPoint from, GeoPoint to) {
        double dx = plane.x(to) - plane.x(from);
        double dy = plane.y(to) - plane.y(from);
        return Math.sqrt(dx * dx + dy * dy);
    }
}
