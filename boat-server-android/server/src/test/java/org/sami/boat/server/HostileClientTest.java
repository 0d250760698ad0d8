package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Frame;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;

/** Clients that send rubbish, repeat themselves or shuffle what they say. */
class HostileClientTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.001, 10, 1.5), new Waypoint(45.002, 10, 1.6));

    private final ServerTestBench bench = new ServerTestBench();
    private final LinkCodec codec = new LinkCodec();

    private static List<byte[]> sessionOfFrames(Client client) {
        List<LinkMessage> messages = List.of(
                new UploadWaypoints("u", "l1", PATH),
                new ReadBack("r"),
                new StartWaypoints("g", "l1", 0),
                new Teleoperate(0.1, 0.1),
                new HoldPosition("h"),
                new StopMotors("s"));
        List<byte[]> frames = new ArrayList<>();
        for (int i = 0; i < messages.size(); i++) {
            frames.add(client.frame(i + 1, messages.get(i)));
        }
        return frames;
    }

    @Test
    void prefixesNoiseAndFlippedBitsNeitherCrashNorMoveABoatThatNobodyStarted() {
        Client client = bench.commander();
        SplittableRandom random = new SplittableRandom(31);
        long sent = 0;
        for (byte[] frame : sessionOfFrames(client)) {
            for (int length = 0; length < frame.length; length++) {
                client.session.receive(Arrays.copyOf(frame, length), bench.nowMs);
                sent++;
            }
        }
        byte[] noise = new byte[2 << 20];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = (byte) random.nextInt();
        }
        client.session.receive(noise, bench.nowMs);
        sent++;
        bench.run(1, client);

        assertThat(client.session.refusedFrames()).isEqualTo(sent);
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(bench.log).isEmpty();
    }

    @Test
    void flippedBitsAreRefused() {
        SplittableRandom random = new SplittableRandom(32);
        for (int round = 0; round < 300; round++) {
            ServerTestBench fresh = new ServerTestBench();
            Client client = fresh.commander();
            for (byte[] frame : sessionOfFrames(client)) {
                byte[] flipped = frame.clone();
                flipped[random.nextInt(flipped.length)] ^= (byte) (1 << random.nextInt(8));
                client.session.receive(random.nextBoolean() ? flipped : frame, fresh.nowMs);
                fresh.run(0.1, client);

                assertThat(fresh.vehicle.port).isBetween(-1.0, 1.0);
                assertThat(fresh.vehicle.starboard).isBetween(-1.0, 1.0);
            }
        }
    }

    @Test
    void framesInAnyOrderAndTenTimesOverAreExecutedOnceAtMost() {
        SplittableRandom random = new SplittableRandom(33);
        for (int round = 0; round < 200; round++) {
            ServerTestBench fresh = new ServerTestBench();
            Client client = fresh.commander();
            List<byte[]> frames = new ArrayList<>();
            for (int i = 0; i < 10; i++) {
                frames.addAll(sessionOfFrames(client));
            }
            for (int i = frames.size() - 1; i > 0; i--) {
                Collections.swap(frames, i, random.nextInt(i + 1));
            }
            for (byte[] frame : frames) {
                client.session.receive(frame, fresh.nowMs);
                fresh.run(0.1);
            }

            assertThat(fresh.log.stream().map(line -> line.split(" ")[0]))
                    .doesNotHaveDuplicates()
                    .contains("s");
        }
    }

    @Test
    void everyFrameOfTheServerCanBeRead() {
        List<Frame> frames = new ArrayList<>();
        ServerSession session = bench.server.connect(bytes -> frames.add(read(bytes)));
        session.receive(new byte[10_000], bench.nowMs);
        session.receive(codec.encode(0, new StopMotors("x".repeat(200))), bench.nowMs);

        assertThat(frames).hasSize(2);
        assertThat(frames).extracting(Frame::sequence).containsExactly(0L, 1L);
    }

    private Frame read(byte[] bytes) {
        try {
            return codec.decode(bytes);
        } catch (LinkException e) {
            throw new AssertionError(e);
        }
    }
}
