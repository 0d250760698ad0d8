package org.sami.crw.sim.run.incident;

import java.util.List;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** What became of the last press of an interrupt. For the engine's thread. */
final class PressOutcome implements HostListener {
    private boolean isJudged;
    private boolean isTaken;

    /** A new press is on its way. */
    void pressing() {
        isJudged = false;
        isTaken = false;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (input instanceof Input.Interrupt) {
            isJudged = true;
            isTaken = effects.stream()
                    .anyMatch(effect -> effect instanceof Effect.Fired || effect instanceof Effect.DecisionOpened);
        }
    }

    /** Whether a transition took it, or the operator is asked for boats. */
    boolean isTaken() {
        return isTaken;
    }

    /** Whether nothing took it. */
    boolean isRefused() {
        return isJudged && !isTaken;
    }
}
