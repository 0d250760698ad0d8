package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.TestVocabulary;

/** A session on the engine, each firing of which is held to the net of the plan {@code main} with two levels of sub-missions. */
final class FollowedSession {
    private static final int DEPTH = 2;

    private FollowedSession() {}

    /** Fails where the net cannot do what the engine does; how many firings, of the mission and of its descendants, the net did after it. */
    static int firings(Project project, List<String> robots, List<Input> inputs) throws PlanNetTooLargeException {
        PlanNet net = net(project, robots);
        Engine engine = new Engine(TestVocabulary.TEST, project);
        EngineState state = engine.newState();
        robots.forEach(robot -> engine.step(state, 0, new Input.ProxyJoined(robot)));
        FollowedNet followed = new FollowedNet(net, 1);
        for (Input input : inputs) {
            for (Effect effect : engine.step(state, 0, input)) {
                assertThat(followed.saw(effect)).isEmpty();
            }
            assertThat(followed.settle()).isEmpty();
        }
        return followed.firings();
    }

    static PlanNet net(Project project, List<String> robots) throws PlanNetTooLargeException {
        return PlanNet.of(new PlanNetRequest(project, TestVocabulary.TEST, "main", robots).toDepth(DEPTH));
    }
}
