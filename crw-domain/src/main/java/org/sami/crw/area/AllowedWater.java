package org.sami.crw.area;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/** Water in which boats may go: finds positions outside of it, and where paths leave it. For one thread. */
public final class AllowedWater {
    private final Water ofPositions;
    private final Water ofPaths;
    private final Map<String, Map<String, int[]>> breaches = new HashMap<>(); // by boat and command; segments in order

    /**
     * Water with forbidden areas.
     *
     * @param ofPositions where boats may be, by their reported positions
     * @param ofPaths where boats may be sent
     */
    public AllowedWater(Water ofPositions, Water ofPaths) {
        this.ofPositions = ofPositions;
        this.ofPaths = ofPaths;
    }

    public void remove(String boat) {
        breaches.remove(boat);
    }

    /** Forgets the paths of commands that the boat no longer has. */
    public void retain(String boat, List<String> commands) {
        breaches.getOrDefault(boat, Map.of()).keySet().retainAll(commands);
    }

    public boolean isForbidden(GeoPoint position) {
        return !ofPositions.allows(List.of(position));
    }

    /** Whether a boat that was at one allowed point and is at another went through what is forbidden. */
    public boolean isForbiddenBetween(GeoPoint before, GeoPoint now) {
        return !before.equals(now) && !isForbidden(before) && !ofPositions.allows(List.of(before, now));
    }

    /** The point to which the boat goes next, where its way there leads through what is forbidden. */
    public Optional<GeoPoint> wayThere(Optional<GeoPoint> position, Entry entry) {
        List<GeoPoint> points = entry.command().points();
        if (position.isEmpty() || entry.visited() >= points.size()) {
            return Optional.empty();
        }
        GeoPoint next = points.get(entry.visited());
        List<GeoPoint> way = List.of(position.get(), next); // it begins where the boat seems to be
        boolean forbidden = ofPositions.allows(List.of(position.get())) && leaves(ofPositions, way, entry.command());
        return forbidden ? Optional.of(next) : Optional.empty();
    }

    /** Where the first segment ahead begins that is forbidden. */
    public Optional<GeoPoint> segment(String boat, Entry entry) {
        List<GeoPoint> points = entry.command().points();
        int[] wrong = breaches.computeIfAbsent(boat, id -> new HashMap<>())
                .computeIfAbsent(entry.command().commandId(), id -> breaches(points, entry.command()));
        for (int segment : wrong) {
            if (segment >= entry.visited()) {
                return Optional.of(points.get(segment));
            }
        }
        return Optional.empty();
    }

    /** The segments, by the index of the point at which they begin, and the last point alone. */
    private int[] breaches(List<GeoPoint> points, BoatCommand command) {
        List<Integer> wrong = new ArrayList<>();
        if (!points.isEmpty() && !ofPaths.allows(points)) {
            for (int i = 0; i < points.size(); i++) {
                if (leaves(ofPaths, points.subList(i, Math.min(i + 2, points.size())), command)) {
                    wrong.add(i);
                }
            }
        }
        return wrong.stream().mapToInt(Integer::intValue).toArray();
    }

    /** Whether a segment or a point lies in a forbidden area, also with the detours of the drive around the command's no-go areas. */
    private static boolean leaves(Water allowed, List<GeoPoint> segment, BoatCommand command) {
        return !allowed.allows(segment)
                && (segment.size() < 2
                        || command.water()
                                .flatMap(limits -> Detour.between(segment.get(0), segment.get(1), limits))
                                .filter(turns -> allowed.allows(joined(segment.get(0), turns, segment.get(1))))
                                .isEmpty());
    }

    private static List<GeoPoint> joined(GeoPoint from, List<GeoPoint> turns, GeoPoint to) {
        List<GeoPoint> way = new ArrayList<>(List.of(from));
        way.addAll(turns);
        way.add(to);
        return way;
    }
}
