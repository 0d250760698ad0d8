package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.operator.mission.FailedAnswers;
import org.sami.crw.operator.mission.Outlooks;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.crw.operator.mission.StuckMissions;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * Finds missions that cannot go on by themselves. Those that were stuck at every look for five seconds are shown with the missions and are faults of
 * the session's health, until they go on or end (docs/session.md). For the engine's thread; models receive the result by one hop.
 */
public final class StuckWatch {
    /** A mission is stuck after this time, in ms: within it everything has been asked and said that follows from an input. */
    public static final long SETTLED_MILLIS = 5_000;

    private final OperatorModels models;
    private final FailedAnswers failed = new FailedAnswers();
    private Map<Long, StuckMission> seen = Map.of(); // by the mission that cannot go on, also before it is shown
    private List<StuckMission> shown = List.of();
    private Set<String> subjects = Set.of(); // of the faults in the session's health

    StuckWatch(OperatorModels models) {
        this.models = models;
    }

    /** Takes up what had failed before the base was restarted. */
    void restore(EngineView view, long atMillis) {
        failed.restore(view, atMillis);
    }

    /** Follows a step. */
    void take(long atMillis, Input input, List<Effect> effects) {
        failed.take(atMillis, input, effects);
    }

    /** Looks at all missions, with their commands, computations and questions of a moment ago. */
    public void look(EngineView view, FleetWants wants, long nowMillis) {
        Map<Long, StuckMission> now = new LinkedHashMap<>();
        for (StuckMission one : StuckMissions.of(view.vocabulary(), view, wants, failed, nowMillis)) {
            StuckMission before = seen.get(one.mission());
            now.put(one.mission(), before == null ? one : one.since(before.sinceMillis()));
        }
        seen = now;
        List<StuckMission> stuck = now.values().stream()
                .filter(one -> nowMillis - one.sinceMillis() >= SETTLED_MILLIS)
                .toList();
        if (!stuck.equals(shown)) {
            shown = stuck;
            show(stuck);
        }
    }

    private void show(List<StuckMission> stuck) {
        Map<Long, List<StuckMission>> byRoot = stuck.stream()
                .collect(Collectors.groupingBy(StuckMission::root, LinkedHashMap::new, Collectors.toList()));
        Set<String> now = new HashSet<>();
        for (List<StuckMission> all : byRoot.values()) {
            HealthFault fault = fault(all);
            now.add(fault.subject());
            models.health().report(fault, all.get(0).sinceMillis());
        }
        subjects.stream()
                .filter(subject -> !now.contains(subject))
                .forEach(subject -> models.health().over(HealthKind.MISSION, subject));
        subjects = now;
        models.post(() -> models.missions().stuck(stuck));
    }

    private static HealthFault fault(List<StuckMission> all) {
        StuckMission first = all.get(0);
        String more = all.size() == 1 ? "" : " (and " + (all.size() - 1) + " sub-missions more)";
        return HealthFault.ofMission(
                first.root(),
                first.title(),
                Priority.HIGH,
                "\"" + first.title() + "\" is stuck: " + first.what() + more,
                first.help());
    }

    /** Whether some mission waits for news that come by themselves. */
    public boolean isNewsAwaited(EngineView view, FleetWants wants) {
        return new Outlooks(view.vocabulary(), view, wants, failed).isNewsAwaited();
    }

    /** Which missions cannot go on at this moment, whether or not that lasts. */
    public List<StuckMission> now(EngineView view, FleetWants wants, long nowMillis) {
        return StuckMissions.of(view.vocabulary(), view, wants, failed, nowMillis);
    }

    /** What can be delivered again for a mission and its sub-missions, as it was seen last; taken: what failed of it counts no longer. */
    public List<Long> takeAgain(long root) {
        List<Long> again = new ArrayList<>();
        seen.values().stream()
                .filter(one -> one.root() == root || one.mission() == root)
                .forEach(one -> again.addAll(one.again()));
        again.forEach(failed::forget);
        return again.stream().distinct().toList();
    }

    /** Forgets what happened. */
    void forget() {
        failed.clear();
        seen = Map.of();
        shown = List.of();
        subjects = Set.of();
    }
}
