package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.testing.TestVocabulary;

/** A copy of a state and its original never influence one another, on every random plan. */
@Tag("long")
class StateCopyTest {
    private static final int SEEDS = 400;

    @Test
    void stepsOfACopyDoNotTouchTheOriginalAndAreThoseOfTheOriginal() {
        int steps = 0;
        for (long seed = 1; seed <= SEEDS; seed++) {
            Engine engine = new Engine(TestVocabulary.TEST, RandomPlans.project(seed), Scenario.LIVELOCK_LIMIT);
            EngineState original = engine.newState();
            for (Scenario.Timed timed : ConservationTest.inputs(seed)) {
                byte[] before = StateCodec.encode(original);
                EngineState copy = original.copy();
                assertThat(StateCodec.encode(copy)).as("Seed %d", seed).isEqualTo(before);

                List<Effect> ofCopy = engine.step(copy, timed.nowMillis(), timed.input());
                byte[] after = StateCodec.encode(copy);
                assertThat(StateCodec.encode(original)).as("Seed %d", seed).isEqualTo(before);

                List<Effect> ofOriginal = engine.step(original, timed.nowMillis(), timed.input());
                assertThat(ofCopy).as("Seed %d", seed).isEqualTo(ofOriginal);
                assertThat(StateCodec.encode(original)).as("Seed %d", seed).isEqualTo(after);
                assertThat(StateCodec.encode(copy)).as("Seed %d", seed).isEqualTo(after);

                original = steps++ % 3 == 0 ? copy : original; // copies of copies, and originals that go on
            }
        }

        assertThat(steps).as("Steps looked at").isGreaterThan(5000);
    }
}
