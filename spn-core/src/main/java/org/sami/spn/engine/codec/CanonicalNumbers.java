package org.sami.spn.engine.codec;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;

/**
 * Numbers that stand for the ids of a session, which depend on everything that ever happened in it. Missions are numbered in
 * the order in which they are written, everything else when it is first spoken of.
 */
final class CanonicalNumbers {
    /** Stands for every mission that runs and is not written. */
    private static final long ELSEWHERE = -1;

    private final Map<Long, MissionState> running;
    private final Map<Long, Long> missions = new HashMap<>();
    private final FirstSpokenNumbers ended = new FirstSpokenNumbers();
    private final FirstSpokenNumbers activations = new FirstSpokenNumbers();
    private final FirstSpokenNumbers visits = new FirstSpokenNumbers();

    /**
     * Numbers some of the running missions.
     *
     * @param written those that will be written, in order
     */
    CanonicalNumbers(Map<Long, MissionState> running, List<MissionState> written) {
        this.running = running;
        written.forEach(m -> missions.put(m.id, missions.size() + 1L));
    }

    long mission(long id) {
        if (id == Ids.NONE) {
            return Ids.NONE;
        }
        Long number = missions.get(id);
        if (number != null) {
            return number;
        }
        return running.containsKey(id) ? ELSEWHERE : ELSEWHERE - ended.of(id);
    }

    long activation(long id) {
        return id == Ids.NONE ? Ids.NONE : activations.of(id);
    }

    long visit(@Nullable Visit visit) {
        return visit == null ? Ids.NONE : visits.of(visit.id);
    }
}
