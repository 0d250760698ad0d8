package org.sami.crw.sim.bench;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.infra.Blackhole;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.Telemetry;

/** What one message costs that is written as a frame and read again, in the mix that a boat sends. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@State(Scope.Thread)
public class CodecBenchmarks {
    private static final int MESSAGES = 10;

    private final LinkCodec codec = new LinkCodec();
    private final LinkMessage[] messages = new LinkMessage[MESSAGES];
    private long sequence;

    /** Seven poses, and one each of what comes now and then. */
    public CodecBenchmarks() {
        for (int i = 0; i < MESSAGES; i++) {
            messages[i] = new Telemetry(
                    45.41234567 + i * 1e-6, 10.98765432, 1.2345678, 1.4987, 87.65432, BoatMode.PATH, 123_456_789L + i);
        }
        messages[3] =
                new SensorReport("water", "temperature", List.of(17.123456), "°C", 45.4123, 10.9876, 123_456_789L);
        messages[6] = new Progress("m12-a345-boat67#base.0.89", 12, false);
        messages[9] = new Ack("m12-a345-boat67#base.0.89/upload");
    }

    /** Writes and reads each message once. */
    @Benchmark
    @OperationsPerInvocation(MESSAGES)
    public void codec(Blackhole hole) throws LinkException {
        for (LinkMessage message : messages) {
            hole.consume(codec.decode(codec.encode(sequence++, message)));
        }
    }
}
