package org.sami.crw.operator.mission;

import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.Value;

/**
 * The missions of a session at a moment.
 *
 * @param missions running missions and the latest that have ended, sub-missions included, in order of creation
 * @param globals latest values of global variables, as far as written, or read by a running plan
 * @param firings number of firings in the session up to the last known one
 */
public record MissionsSnapshot(List<MissionSnapshot> missions, Map<String, Value> globals, long firings) {
    public static final MissionsSnapshot EMPTY = new MissionsSnapshot(List.of(), Map.of(), 0);

    public MissionsSnapshot {
        missions = List.copyOf(missions);
        globals = Collections.unmodifiableMap(new LinkedHashMap<>(globals));
    }

    /** One mission. */
    public Optional<MissionSnapshot> mission(long id) {
        return missions.stream().filter(mission -> mission.id() == id).findFirst();
    }

    /** The missions that have ended or were halted, without sub-missions; the latest first. */
    public List<MissionSnapshot> ended() {
        return missions.stream()
                .filter(mission -> mission.hasEnded() && mission.parent() == Ids.NONE)
                .sorted(Comparator.comparingLong((MissionSnapshot mission) ->
                                mission.endedAtMillis().orElse(Long.MAX_VALUE))
                        .thenComparingLong(MissionSnapshot::id)
                        .reversed())
                .toList();
    }

    /** The missions that go on, in order of creation. */
    public List<MissionSnapshot> running() {
        return missions.stream().filter(mission -> !mission.hasEnded()).toList();
    }
}
