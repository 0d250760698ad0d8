package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.CommandQueueSnapshot;
import org.sami.crw.proxy.FollowPath;
import org.sami.crw.proxy.KeepStation;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * Whether boats are, go or are sent where they may not: by position, by the way between two positions, and by each segment of their paths.
 * For one thread.
 */
final class FenceCheck {
    private final Map<String, GeoPoint> last = new HashMap<>();
    private final Map<String, Map<String, int[]>> breaches = new HashMap<>(); // by boat and command; segments in order
    private Optional<Water> water = Optional.empty();

    /** From now on boats may go in this water; empty for everywhere. */
    void setWater(Optional<Water> allowed) {
        water = allowed;
        breaches.clear();
    }

    void remove(String boat) {
        last.remove(boat);
        breaches.remove(boat);
    }

    /** What is wrong with where a boat is, or with the way that it came since it was seen last. */
    Optional<String> position(String boat, GeoPoint position) {
        GeoPoint before = last.put(boat, position);
        if (isForbidden(List.of(position))) {
            return Optional.of(boat + " is outside of the water in which boats may go");
        }
        boolean wasAllowed = before != null && !before.equals(position) && !isForbidden(List.of(before));
        return wasAllowed && isForbidden(List.of(before, position))
                ? Optional.of(boat + " went through water in which boats may not go")
                : Optional.empty();
    }

    /** What is wrong with where a boat is sent. */
    Optional<String> path(String boat, Optional<GeoPoint> position, CommandQueueSnapshot queue) {
        if (water.isEmpty()) {
            return Optional.empty();
        }
        List<String> queued = new ArrayList<>();
        Optional<String> wrong = queue.current().flatMap(entry -> {
            queued.add(entry.command().commandId());
            return wayThere(boat, position, entry).or(() -> segment(boat, entry));
        });
        for (CommandQueueSnapshot.Entry entry : queue.waiting()) {
            queued.add(entry.command().commandId());
            if (wrong.isEmpty()) {
                wrong = segment(boat, entry);
            }
        }
        breaches.getOrDefault(boat, Map.of()).keySet().retainAll(queued);
        return wrong;
    }

    /** The way from the boat to its next point, which is another one at each position. */
    private Optional<String> wayThere(String boat, Optional<GeoPoint> position, CommandQueueSnapshot.Entry entry) {
        List<GeoPoint> points = points(entry.command());
        if (position.isEmpty() || entry.visited() >= points.size()) {
            return Optional.empty();
        }
        GeoPoint next = points.get(entry.visited());
        return !isForbidden(List.of(position.get())) && isForbidden(List.of(position.get(), next))
                ? Optional.of(words(boat, entry, "to", next))
                : Optional.empty();
    }

    /** The first segment ahead that is forbidden. */
    private Optional<String> segment(String boat, CommandQueueSnapshot.Entry entry) {
        List<GeoPoint> points = points(entry.command());
        int[] wrong = breaches.computeIfAbsent(boat, id -> new HashMap<>())
                .computeIfAbsent(entry.command().commandId(), id -> breaches(points));
        for (int segment : wrong) {
            if (segment >= entry.visited()) {
                return Optional.of(words(boat, entry, "near", points.get(segment)));
            }
        }
        return Optional.empty();
    }

    /** The segments, by the index of the point at which they begin, and the last point alone. */
    private int[] breaches(List<GeoPoint> points) {
        List<Integer> wrong = new ArrayList<>();
        if (isForbidden(points)) {
            for (int i = 0; i < points.size(); i++) {
                if (isForbidden(points.subList(i, Math.min(i + 2, points.size())))) {
                    wrong.add(i);
                }
            }
        }
        return wrong.stream().mapToInt(Integer::intValue).toArray();
    }

    private static List<GeoPoint> points(BoatCommand command) {
        if (command instanceof FollowPath path) {
            return path.points();
        }
        return command instanceof KeepStation station ? List.of(station.point()) : List.of();
    }

    private boolean isForbidden(List<GeoPoint> way) {
        return water.isPresent() && !way.isEmpty() && !water.get().allows(way);
    }

    private static String words(String boat, CommandQueueSnapshot.Entry entry, String where, GeoPoint point) {
        return String.format(
                Locale.ROOT,
                "Mission %d sends %s through water in which boats may not go, %s %.5f,%.5f",
                entry.command().mission(),
                boat,
                where,
                point.latDeg(),
                point.lonDeg());
    }
}
