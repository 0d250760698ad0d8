package org.sami.spn.stepping;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Outcome;

/** A run at one moment: the engine's state and what effects have told that the state does not keep. */
final class Moment {
    final EngineState state;
    /** Activations whose visits have not ended, and those of end places. */
    final Map<Long, Activation> activations = new LinkedHashMap<>();

    long nowMillis;
    long mission = Ids.NONE;
    Optional<Outcome> outcome = Optional.empty();

    Moment(EngineState state) {
        this.state = state;
    }

    Moment copy() {
        Moment copy = new Moment(state.copy());
        copy.activations.putAll(activations);
        copy.nowMillis = nowMillis;
        copy.mission = mission;
        copy.outcome = outcome;
        return copy;
    }

    void saw(Effect effect) {
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
