package org.sami.crw.operator.alarm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.area.AllowedWater;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.CommandQueueSnapshot.Entry;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Whether boats are, go or are sent where they may not: by position, by the way between two positions, and by each segment of their paths.
 * The water of the session binds every boat; what a mission avoids binds those that carry out its commands (docs/operator-models.md). For one
 * thread.
 */
public final class FenceCheck {
    private final MissionTitles titles;
    private final Map<String, GeoPoint> last = new HashMap<>();
    private Optional<AllowedWater> fence = Optional.empty();
    private Map<Long, List<GeoArea>> avoided = Map.of();
    private Map<Long, AllowedWater> missions = Map.of();

    public FenceCheck(MissionTitles titles) {
        this.titles = titles;
    }

    /** From now on boats may go in this water; empty for everywhere. */
    public void setWater(Optional<Water> allowed) {
        fence = allowed.map(water -> new AllowedWater(water, water));
    }

    /** From now on missions keep out of these areas, by mission. */
    public void setAvoided(Map<Long, List<GeoArea>> areas) {
        Map<Long, AllowedWater> now = new LinkedHashMap<>();
        areas.forEach((mission, avoid) -> {
            if (avoid.equals(avoided.get(mission))) {
                Optional.ofNullable(missions.get(mission)).ifPresent(same -> now.put(mission, same));
            } else {
                water(avoid).ifPresent(water -> now.put(mission, water));
            }
        });
        avoided = Map.copyOf(areas);
        missions = now;
    }

    /** Empty for an area that is no simple polygon: the mission's own request is refused with the reason. */
    private static Optional<AllowedWater> water(List<GeoArea> avoid) {
        try {
            Water water = Water.of(avoid.get(0).outline().get(0), avoid, Optional.empty());
            return Optional.of(new AllowedWater(
                    water.shrunk(AlarmLimits.NO_GO_DEPTH_M), water.shrunk(AlarmLimits.NO_GO_PATH_DEPTH_M)));
        } catch (IllegalArgumentException crossed) {
            return Optional.empty();
        }
    }

    void remove(String boat) {
        last.remove(boat);
        fence.ifPresent(water -> water.remove(boat));
        missions.values().forEach(water -> water.remove(boat));
    }

    /** What is wrong with where a boat is, or with the way that it came since it was seen last. */
    Optional<String> position(String boat, GeoPoint position, CommandQueueSnapshot queue) {
        Optional<GeoPoint> before = Optional.ofNullable(last.put(boat, position));
        Optional<String> wrong = fence.flatMap(water -> position(
                water,
                before,
                position,
                boat + " is outside of the water in which boats may go",
                boat + " went through water in which boats may not go"));
        return wrong.or(() -> queue.current()
                .flatMap(entry -> of(entry).flatMap(water -> {
                    String area = "an area that " + titles.words(entry.command().mission()) + " is to keep out of";
                    return position(water, before, position, boat + " is in " + area, boat + " went through " + area);
                })));
    }

    private static Optional<String> position(
            AllowedWater water, Optional<GeoPoint> before, GeoPoint now, String isThere, String wasThere) {
        if (water.isForbidden(now)) {
            return Optional.of(isThere);
        }
        return before.filter(then -> water.isForbiddenBetween(then, now)).map(then -> wasThere);
    }

    /** What is wrong with where a boat is sent. */
    Optional<String> path(String boat, Optional<GeoPoint> position, CommandQueueSnapshot queue) {
        List<Entry> entries = new ArrayList<>(queue.waiting());
        queue.current().ifPresent(current -> entries.add(0, current));
        List<String> commands =
                entries.stream().map(entry -> entry.command().commandId()).toList();
        fence.ifPresent(water -> water.retain(boat, commands));
        missions.values().forEach(water -> water.retain(boat, commands));
        for (Entry entry : entries) {
            Optional<GeoPoint> from = queue.current().filter(entry::equals).isPresent() ? position : Optional.empty();
            Optional<String> wrong = path(fence, boat, from, entry, "water in which boats may not go")
                    .or(() -> path(of(entry), boat, from, entry, "an area that it is to keep out of"));
            if (wrong.isPresent()) {
                return wrong;
            }
        }
        return Optional.empty();
    }

    private Optional<AllowedWater> of(Entry entry) {
        return Optional.ofNullable(missions.get(entry.command().mission()));
    }

    private Optional<String> path(
            Optional<AllowedWater> guarded, String boat, Optional<GeoPoint> from, Entry entry, String what) {
        return guarded.flatMap(water -> water.wayThere(from, entry)
                .map(point -> words(boat, entry, what, "to", point))
                .or(() -> water.segment(boat, entry).map(point -> words(boat, entry, what, "near", point))));
    }

    private String words(String boat, Entry entry, String what, String where, GeoPoint point) {
        String mission = titles.words(entry.command().mission());
        return String.format(
                Locale.ROOT,
                "%s sends %s through %s, %s %.5f,%.5f",
                Character.toUpperCase(mission.charAt(0)) + mission.substring(1),
                boat,
                what,
                where,
                point.latDeg(),
                point.lonDeg());
    }
}
