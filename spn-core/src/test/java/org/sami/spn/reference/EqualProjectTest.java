package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.TestVocabulary;

/** A random session in which the project that it has is loaded again goes as if only time had passed then. */
@Tag("long")
class EqualProjectTest {
    private static final int SESSIONS = 1000;

    private int loads;

    @Test
    void loadingAnEqualProjectIsAsIfOnlyTimeHadPassed() {
        for (int i = 1; i <= SESSIONS; i++) {
            long seed = i;
            try {
                RandomLoads.readable(RandomPlans.project(seed)).ifPresent(project -> session(project, seed));
            } catch (World.TooManyTokens e) {
                // a random plan that breeds tokens is of no interest
            }
        }
        assertThat(loads).isGreaterThan(SESSIONS / 5);
    }

    private void session(Project project, long seed) {
        Engine engine = new Engine(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
        EngineState loading = engine.newState();
        EngineState without = engine.newState();
        Subject interpreter = Differential.interpreter(project);
        RandomInputs world = new RandomInputs(project, seed, List.of(RandomLoads.load(project)));
        for (int i = 0; i < Scenario.LENGTH; i++) {
            Scenario.Timed timed = world.next(interpreter);
            long now = timed.nowMillis();
            world.saw(interpreter.step(now, timed.input()));
            Input other = timed.input();
            List<Effect> effects = new ArrayList<>(engine.step(loading, now, timed.input()));
            if (timed.input() instanceof Input.LoadProject) {
                loads++;
                other = new Input.TimeReached();
                assertThat(effects.remove(effects.size() - 1)).isEqualTo(new Effect.ProjectLoaded(1, project));
            }

            assertThat(effects).as("seed %d, input %d", seed, i).isEqualTo(engine.step(without, now, other));
            assertThat(StateCodec.encode(loading)).as("seed %d", seed).isEqualTo(StateCodec.encode(without));
        }
    }
}
