package org.sami.bench;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.engine.StateKey;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** What it costs to try an input out: to copy a state and step the copy, and to name the state that is reached. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
public class StateBenchmarks {
    /** One mission of a ring of ten places, robots on their way. */
    @State(Scope.Thread)
    public static class Session {
        /** How many robots. */
        @Param({"10", "100"})
        public int boats;

        Run run;
        Input input;

        /** Starts over and lets every robot go on, some further than others. */
        @Setup(Level.Iteration)
        public void start() {
            run = new Run(Rings.robots(10), boats, 1);
            for (int i = 0; i < boats * 7 / 2; i++) {
                run.next();
            }
            input = run.answer();
        }
    }

    /** engine.copyStep: a structural copy, one step on it. */
    @Benchmark
    public List<Effect> copyStep(Session s) {
        return s.run.engine.step(s.run.state.copy(), 0, s.input);
    }

    /** engine.copyStepThroughBytes: the same, the copy made by encoding and decoding. */
    @Benchmark
    public List<Effect> copyStepThroughBytes(Session s) {
        EngineState copy = StateCodec.decode(StateCodec.encode(s.run.state), s.run.engine);
        return s.run.engine.step(copy, 0, s.input);
    }

    /** engine.stateKey. */
    @Benchmark
    public StateKey stateKey(Session s) {
        return StateKey.of(s.run.state);
    }
}
