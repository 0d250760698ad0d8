package org.sami.crw.sim.run.incident;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;

/**
 * Which missions of a run are running, roots and sub-missions. A root in the background does not count: it runs until the others have ended. For the engine's thread.
 */
final class RunMissions implements HostListener {
    private final BackgroundActions background;
    private final Map<Long, String> running = new TreeMap<>(); // plan by mission
    private final Map<Long, String> roots = new HashMap<>();
    private OptionalLong firstStart = OptionalLong.empty();
    private long lastEnd;
    private int joined;
    private boolean halted;

    RunMissions(BackgroundActions background) {
        this.background = background;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        joined += input instanceof Input.ProxyJoined ? 1 : 0;
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                started(started, atMillis);
            } else if (effect instanceof Effect.MissionEnded ended) {
                running.remove(ended.mission());
                if (roots.remove(ended.mission()) != null) {
                    lastEnd = atMillis;
                    halted |= ended.outcome() == Outcome.HALTED;
                }
            }
        }
    }

    private void started(Effect.MissionStarted started, long atMillis) {
        running.put(started.mission(), started.plan());
        if (started.parent() == Ids.NONE && !started.plan().equals(background.plan())) {
            roots.put(started.mission(), started.plan());
            firstStart = firstStart.isPresent() ? firstStart : OptionalLong.of(atMillis);
        }
    }

    boolean anyRoot() {
        return !roots.isEmpty();
    }

    boolean isRunning(String plan) {
        return running.containsValue(plan);
    }

    /** The plans of the running root missions, each once, by name. */
    Set<String> running() {
        return new TreeSet<>(roots.values());
    }

    /** Ids of the running root missions of a plan. */
    Set<Long> rootsOf(String plan) {
        return roots.entrySet().stream()
                .filter(root -> root.getValue().equals(plan))
                .map(Map.Entry::getKey)
                .collect(Collectors.toSet());
    }

    OptionalLong firstStart() {
        return firstStart;
    }

    /** From the first start to the last end. */
    long millis() {
        return firstStart.isEmpty() ? 0 : Math.max(0, lastEnd - firstStart.getAsLong());
    }

    int joined() {
        return joined;
    }

    boolean isHalted() {
        return halted;
    }
}
