package org.sami.crw.session;

import java.util.List;
import org.sami.session.api.RefusedException;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;

/** Reads from what followed from an input whether it did what its poster wished. */
final class EngineAnswers {
    private EngineAnswers() {}

    /** The root mission that was started. */
    static long startedMission(List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted mission && mission.parent() == Ids.NONE) {
                return mission.mission();
            }
        }
        throw new RefusedException("the mission did not start");
    }

    /** Makes sure that the decision is answered. */
    static Void answered(long decision, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionClosed closed && closed.decision() == decision) {
                return null;
            }
        }
        throw new RefusedException("the question stays open: the answer names nobody");
    }
}
