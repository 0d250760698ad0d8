package org.sami.crw.sim.run.record;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.report.RunOutcome;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;

/** The progress of a run's missions. The first root missions, as many as the run starts, belong to the run. A function of the journal's entries. */
public final class RunMission implements HostListener {
    private final int count;
    private final Map<Long, Optional<Outcome>> roots = new LinkedHashMap<>();
    private OptionalLong startedAtMillis = OptionalLong.empty();
    private OptionalLong lastEndedAtMillis = OptionalLong.empty();
    private Optional<String> failure = Optional.empty();
    private String lastNote = "the mission did not start";
    private int boatsJoined;
    private long lastInputMillis;

    /**
     * Missions that have not started.
     *
     * @param count how many the run starts
     */
    RunMission(int count) {
        this.count = count;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        lastInputMillis = atMillis;
        boatsJoined += input instanceof Input.ProxyJoined ? 1 : 0;
        int before = roots.size();
        for (Effect effect : effects) {
            take(atMillis, effect);
        }
        if (input instanceof Input.StartMission && roots.size() == before && before < count) {
            failure = Optional.of(lastNote);
        }
    }

    private void take(long atMillis, Effect effect) {
        if (effect instanceof Effect.MissionStarted started && started.parent() == Ids.NONE && roots.size() < count) {
            roots.put(started.mission(), Optional.empty());
            startedAtMillis = startedAtMillis.isPresent() ? startedAtMillis : OptionalLong.of(atMillis);
        } else if (effect instanceof Effect.MissionEnded ended && roots.containsKey(ended.mission())) {
            over(ended.mission(), ended.outcome(), atMillis);
        } else if (effect instanceof Effect.Noted noted) {
            lastNote = noted.message();
            if (noted.kind() == NoteKind.LIVELOCK && roots.containsKey(noted.mission())) {
                over(noted.mission(), Outcome.HALTED, atMillis);
            }
        }
    }

    private void over(long mission, Outcome how, long atMillis) {
        roots.put(mission, Optional.of(how));
        lastEndedAtMillis = OptionalLong.of(atMillis);
    }

    @Override
    public void onFailed(HostStatus status) {
        failure = Optional.of(status.whole());
    }

    /** Whether all missions of the run are over. */
    public boolean isOver() {
        return roots.size() == count && roots.values().stream().allMatch(Optional::isPresent);
    }

    /** The worst outcome of the run's missions; empty until all have ended. */
    public Optional<RunOutcome> result() {
        if (!isOver()) {
            return Optional.empty();
        }
        List<Outcome> ends = roots.values().stream().flatMap(Optional::stream).toList();
        return Optional.of(
                ends.contains(Outcome.HALTED)
                        ? RunOutcome.FAILED
                        : ends.contains(Outcome.ABORTED) ? RunOutcome.ABORTED : RunOutcome.ENDED);
    }

    /** The end of the run's last mission; empty until all have ended. */
    public OptionalLong endedAtMillis() {
        return isOver() ? lastEndedAtMillis : OptionalLong.empty();
    }

    /** The reason why the run cannot go on, in one sentence; empty while it can. */
    public Optional<String> failure() {
        return failure;
    }

    /** Number of missions of the run that have started. */
    public int started() {
        return roots.size();
    }

    /** The start of the first mission; empty before. */
    public OptionalLong startedAtMillis() {
        return startedAtMillis;
    }

    /** Time of the engine's last input. */
    public long lastInputMillis() {
        return lastInputMillis;
    }

    /** Number of boats that the engine knows. */
    public int boatsJoined() {
        return boatsJoined;
    }
}
