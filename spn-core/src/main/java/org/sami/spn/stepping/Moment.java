package org.sami.spn.stepping;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A run at one moment: the engine's state and what effects have reported and the state does not keep. It is changed while a step is taken, and
 * not again.
 */
final class Moment {
    final EngineState state;
    /** Activations whose visits have not ended, and those of end places. */
    final Map<Long, Activation> activations = new LinkedHashMap<>();

    final RobotTasks tasks;
    long nowMillis;
    long mission = Ids.NONE;
    Optional<Outcome> outcome = Optional.empty();
    private @Nullable MomentKey key;
    private @Nullable String summary;

    Moment(EngineState state) {
        this(state, new RobotTasks());
    }

    private Moment(EngineState state, RobotTasks tasks) {
        this.state = state;
        this.tasks = tasks;
    }

    Moment copy() {
        Moment copy = new Moment(state.copy(), tasks.copy());
        copy.activations.putAll(activations);
        copy.nowMillis = nowMillis;
        copy.mission = mission;
        copy.outcome = outcome;
        return copy;
    }

    /** Its key, computed when it is first asked for; not while a step is taken. */
    MomentKey key() {
        if (key == null) {
            key = MomentKey.of(state, tasks);
        }
        return key;
    }

    /** Its {@link MomentSummary}, computed when it is first asked for; not while a step is taken. */
    String summary(Engine engine) {
        if (summary == null) {
            summary = MomentSummary.of(engine.view(state), tasks.words());
        }
        return summary;
    }

    void saw(Effect effect, Vocabulary vocabulary) {
        tasks.saw(effect, vocabulary);
        if (effect instanceof Effect.Activated e) {
            activations.put(e.activation().id(), e.activation());
        } else if (effect instanceof Effect.ActivationEnded e) {
            activations.remove(e.activation());
        } else if (effect instanceof Effect.MissionStarted e && mission == Ids.NONE) {
            mission = e.mission();
        } else if (effect instanceof Effect.MissionEnded e && e.mission() == mission) {
            outcome = Optional.of(e.outcome());
        }
    }
}
