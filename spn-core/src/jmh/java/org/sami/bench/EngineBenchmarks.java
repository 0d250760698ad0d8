package org.sami.bench;

import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** What one input costs the engine, with all its effects built. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
public class EngineBenchmarks {
    /** How many reports one invocation of the barrier makes: whole rounds of all sizes. */
    private static final int REPORTS = 1000;

    /** Ten places, one token. */
    @State(Scope.Thread)
    public static class Ring {
        Run run;

        /** Starts over. */
        @Setup(Level.Iteration)
        public void start() {
            run = new Run(Rings.generic(10), 0, 1);
        }
    }

    /** One mission with many robots. */
    @State(Scope.Thread)
    public static class ManyRobots {
        /** How many. */
        @Param({"10", "100", "1000"})
        public int boats;

        Run run;

        /** Starts over. */
        @Setup(Level.Iteration)
        public void start() {
            run = new Run(Rings.robots(10), boats, 1);
        }
    }

    /** Many missions with ten robots. */
    @State(Scope.Thread)
    public static class ManyMissions {
        /** How many. */
        @Param({"1", "100", "1000"})
        public int missions;

        Run run;

        /** Starts over. */
        @Setup(Level.Iteration)
        public void start() {
            run = new Run(Rings.robots(10), 10, missions);
        }
    }

    /** Places that wait for all robots. */
    @State(Scope.Thread)
    public static class Barrier {
        /** How many robots have to report. */
        @Param({"100", "1000"})
        public int boats;

        Run run;

        /** Starts over. */
        @Setup(Level.Iteration)
        public void start() {
            run = new Run(Rings.together(2), boats, 1);
        }
    }

    /** An engine with ten robots in which missions start. */
    @State(Scope.Thread)
    public static class Starting {
        Engine engine;
        EngineState state;
        long mission;

        /** Starts over. */
        @Setup(Level.Iteration)
        public void start() {
            Run run = new Run(Rings.robots(10), 10, 1);
            engine = run.engine;
            state = run.state;
            mission = 1;
        }
    }

    /** engine.ring. */
    @Benchmark
    public List<Effect> ring(Ring ring) {
        return ring.run.next();
    }

    /** engine.proxies by robots. */
    @Benchmark
    public List<Effect> proxiesByBoats(ManyRobots many) {
        return many.run.next();
    }

    /** engine.proxies by missions. */
    @Benchmark
    public List<Effect> proxiesByMissions(ManyMissions many) {
        return many.run.next();
    }

    /** engine.barrier: rounds of reports, the last of each moves everybody on. */
    @Benchmark
    @OperationsPerInvocation(REPORTS)
    public void barrier(Barrier barrier) {
        for (int i = 0; i < REPORTS; i++) {
            barrier.run.next();
        }
    }

    /** engine.start: a mission is started, and aborted again so that the state stays small; the sum of both. */
    @Benchmark
    @BenchmarkMode(Mode.AverageTime)
    @OutputTimeUnit(TimeUnit.MICROSECONDS)
    public List<Effect> start(Starting s) {
        List<Effect> effects = s.engine.step(s.state, 0, new Input.StartMission("ring", "ring", Map.of()));
        if (effects.size() != 2) {
            throw new IllegalStateException("A mission starts and activates its first output: " + effects);
        }
        s.engine.step(s.state, 0, new Input.AbortMission(++s.mission));
        return effects;
    }
}
