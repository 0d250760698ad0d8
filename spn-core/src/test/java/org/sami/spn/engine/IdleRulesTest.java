package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** An engine's rules work on one state after the other, and bring nothing from one to the next. */
class IdleRulesTest {
    private static final Input START = new Input.StartMission("net", "net", Map.of());
    private static final int STATES = 500;

    /** Three firings follow the start: one, and one more from each of the two places that it marks. */
    private final Engine engine = new Engine(
            TestVocabulary.TEST,
            NetBuilder.project(new NetBuilder("net")
                    .start("p0")
                    .transition("t0")
                    .in("p0", "t0", "generic >= 1")
                    .out("t0", "p1", "add 2 generic")
                    .out("t0", "p2", "take 1 generic")
                    .transition("t1")
                    .in("p1", "t1", "generic >= 2")
                    .out("t1", "p3", "take all generic")
                    .transition("t2")
                    .in("p2", "t2", "generic >= 1")
                    .out("t2", "p3", "take 1 generic")
                    .build()));

    @Test
    void aStepThatEndsInAFaultLeavesNothingToOtherStates() {
        byte[] expected = started();

        EngineState broken = engine.newState();
        assertThatThrownBy(() -> engine.step(broken, 0, START, IdleRulesTest::refuseFirings))
                .hasMessage("refused");

        assertThat(started()).isEqualTo(expected);
    }

    private static void refuseFirings(Effect effect) {
        if (effect instanceof Effect.Fired) {
            throw new IllegalStateException("refused");
        }
    }

    @Test
    void whoStepsAnotherStateWhileEffectsComeDisturbsNeither() {
        byte[] expected = started();
        List<byte[]> inner = new ArrayList<>();

        EngineState outer = engine.newState();
        engine.step(outer, 0, START, effect -> inner.add(started()));

        assertThat(StateCodec.encode(outer)).isEqualTo(expected);
        assertThat(inner)
                .hasSizeGreaterThan(3)
                .allSatisfy(state -> assertThat(state).isEqualTo(expected));
    }

    @Test
    void threadsThatShareAnEngineStepTheirOwnStates() throws Exception {
        byte[] expected = started();
        ExecutorService threads = Executors.newFixedThreadPool(3);

        List<Future<List<byte[]>>> made = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            made.add(threads.submit(this::many));
        }

        for (Future<List<byte[]>> states : made) {
            assertThat(states.get())
                    .hasSize(STATES)
                    .allSatisfy(state -> assertThat(state).isEqualTo(expected));
        }
        threads.shutdown();
    }

    private List<byte[]> many() {
        List<byte[]> states = new ArrayList<>();
        for (int i = 0; i < STATES; i++) {
            states.add(started());
        }
        return states;
    }

    /** A state in which the mission was started and has fired what it could. */
    private byte[] started() {
        EngineState state = engine.newState();
        assertThat(engine.step(state, 0, START))
                .filteredOn(Effect.Fired.class::isInstance)
                .hasSize(3);
        return StateCodec.encode(state);
    }
}
