package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;

/** How far the mission of a run is: one root mission is the run's. A function of the journal's entries. */
public final class RunMission implements HostListener {
    private OptionalLong root = OptionalLong.empty();
    private Optional<Outcome> outcome = Optional.empty();
    private OptionalLong endedAtMillis = OptionalLong.empty();
    private Optional<String> failure = Optional.empty();
    private String lastNote = "the mission did not start";
    private int boatsJoined;
    private long lastInputMillis;

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        lastInputMillis = atMillis;
        boatsJoined += input instanceof Input.ProxyJoined ? 1 : 0;
        for (Effect effect : effects) {
            take(atMillis, effect);
        }
        if (input instanceof Input.StartMission && root.isEmpty()) {
            failure = Optional.of(lastNote);
        }
    }

    private void take(long atMillis, Effect effect) {
        if (effect instanceof Effect.MissionStarted started && started.parent() == Ids.NONE && root.isEmpty()) {
            root = OptionalLong.of(started.mission());
        } else if (effect instanceof Effect.MissionEnded ended && isRoot(ended.mission())) {
            over(ended.outcome(), atMillis);
        } else if (effect instanceof Effect.Noted noted) {
            lastNote = noted.message();
            if (noted.kind() == NoteKind.LIVELOCK && isRoot(noted.mission())) {
                over(Outcome.HALTED, atMillis);
            }
        }
    }

    private void over(Outcome how, long atMillis) {
        outcome = Optional.of(how);
        endedAtMillis = OptionalLong.of(atMillis);
    }

    private boolean isRoot(long mission) {
        return root.isPresent() && root.getAsLong() == mission;
    }

    @Override
    public void onFailed(HostStatus status) {
        failure = Optional.of(status.whole());
    }

    /** How the run's mission ended; empty while it goes on. */
    public Optional<Outcome> outcome() {
        return outcome;
    }

    /** The same as the run's own outcome; empty while it goes on. */
    public Optional<RunOutcome> result() {
        return outcome.map(how -> switch (how) {
            case ENDED, COMPLETED -> RunOutcome.ENDED;
            case ABORTED -> RunOutcome.ABORTED;
            case HALTED -> RunOutcome.FAILED;
        });
    }

    /** When the run's mission ended; empty while it goes on. */
    public OptionalLong endedAtMillis() {
        return endedAtMillis;
    }

    /** Why the run cannot go on, in one sentence; empty while it can. */
    public Optional<String> failure() {
        return failure;
    }

    /** The run's mission, empty before it started. */
    public OptionalLong root() {
        return root;
    }

    /** When the engine last took something in. */
    public long lastInputMillis() {
        return lastInputMillis;
    }

    /** How many boats the engine has got to know. */
    public int boatsJoined() {
        return boatsJoined;
    }
}
