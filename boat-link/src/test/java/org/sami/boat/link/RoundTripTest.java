package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class RoundTripTest {
    private final LinkCodec codec = new LinkCodec();

    static Stream<LinkMessage> messages() {
        List<Waypoint> path =
                List.of(new Waypoint(45.4, 10.9, 1.5), new Waypoint(-90, 180, 0), new Waypoint(1e-9, -180, 3));
        return Stream.of(
                new Hello("boat1", "base", Role.COMMANDER, 10, "secret"),
                new Welcome("boat1", "b-7", Role.OBSERVER, ""),
                new Hello("boat1", "base", Role.COMMANDER, 10, "", "base.0", 7),
                new Welcome("boat1", "b-7", Role.COMMANDER, "b-7.1", "", true),
                new Welcome("boat1", "b-7", Role.OBSERVER, "", "", true, Optional.of(new CommandEpoch(7, "", "base2"))),
                new Pair("laptop", "0123456789abcdef".repeat(4)),
                new Pair("laptop", "0123456789abcdef".repeat(4), Role.OBSERVER),
                new Paired("boat1", "0123456789abcdef".repeat(4), Role.COMMANDER),
                new WithdrawKeys("c", List.of("0123456789abcdef".repeat(4))),
                new AskForCommand("c", "base.0", 7),
                new TakeCommand("c", "base.0", Long.MAX_VALUE),
                new Goodbye("boat1", "you mean another boat"),
                new Heartbeat(Long.MAX_VALUE),
                new Ack("m3-a17-boat2"),
                new Nack("", NackReason.MALFORMED, "ünreadable \"\\ \u0001"),
                new UploadWaypoints("c", "l", path),
                new UploadWaypoints("c", "l", List.of()),
                new ReadBack("c"),
                new HeldWaypoints("c", "", path),
                new StartWaypoints("c", "l", Integer.MAX_VALUE),
                new StopMotors("c"),
                new HoldPosition("c"),
                new TakePanorama("c", 360),
                new PanoramaReport("c", 8, 45.4, -10.9),
                new PanoramaReport("c", 8, 45.4, -10.9, List.of("anna-000012.jpg", "anna-000013.jpg")),
                new FleetStop("c"),
                new FleetRelease("c"),
                new AskForCommand("c"),
                new GrantCommand("c", "base2"),
                new TakeCommand("c"),
                new CommandAsked("base2"),
                new Teleoperate(-1, 0.25),
                new SetGains("c", GainAxis.SPEED, 0.1, 0, 1000),
                new SetVelocityMultiplier("c", 0.5),
                new SetLostLinkAction("c", LostLinkAction.DRIFT),
                new Telemetry(45.41234567890123, 10.9, -3.1, -0.2, 99.5, BoatMode.RETURN, 12),
                new Telemetry(45.4, 10.9, 0, 1.5, 99, BoatMode.PATH, 12, OptionalDouble.of(4), "bert"),
                new Motion(45.41234567890123, -10.9, 3.1, -0.2, BoatMode.PATH),
                new Traffic(List.of(
                        new NearbyBoat("boat2", 45.4, 10.9, -3.1, 1.5, BoatMode.PATH, 240, 45.41, -180),
                        new NearbyBoat("boat3", -45.4, 10.9, 0, 0, BoatMode.STOPPED, 0))),
                new Traffic(
                        List.of(),
                        Optional.of(new NoGoEdges(
                                0.6, List.of(new NoGoEdge(45.4, 10.9, 45.41, -180), new NoGoEdge(-90, 10.9, 0, 0))))),
                new BatteryReport(30, BatteryLevel.LOW),
                new Progress("l", 3, true),
                new SettingsReport(new Gains(1.2, 0, 0), new Gains(0.3, 0.05, 1000), 2.5, LostLinkAction.RETURN),
                new SettingsReport(
                        new Gains(1.2, 0, 0),
                        new Gains(0.3, 0, 0),
                        1,
                        LostLinkAction.HOLD,
                        Optional.of(new Waypoint(45.4, -10.9, 1)),
                        Optional.of(new TrackingError(1.57, 0.24))),
                new SettingsReport(
                        new Gains(1.2, 0, 0),
                        new Gains(0.3, 0, 0),
                        1,
                        LostLinkAction.HOLD,
                        Optional.empty(),
                        Optional.empty(),
                        "base2",
                        Optional.of(BoardCondition.SILENT)),
                new SettingsReport(new Gains(1.2, 0, 0), new Gains(0.3, 0, 0), 1, LostLinkAction.HOLD)
                        .with(new BoatPerformance(
                                OptionalDouble.of(15), OptionalDouble.of(2.25), OptionalDouble.of(0))),
                new SettingsReport(new Gains(1.2, 0, 0), new Gains(0.3, 0, 0), 1, LostLinkAction.HOLD)
                        .with(new BoatPerformance(
                                OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.of(4.5))),
                new SettingsReport(new Gains(1.2, 0, 0), new Gains(0.3, 0, 0), 1, LostLinkAction.HOLD)
                        .with(BoatPerformance.UNKNOWN.with(
                                new PowerCurve(new double[] {0, 1.5, 3}, new double[] {2, 150, 1200}))),
                new SettingsReport(new Gains(1.2, 0, 0), new Gains(0.3, 0, 0), 1, LostLinkAction.HOLD)
                        .with(new BoatCapabilities(
                                Collections.singletonMap("panorama", "there is no camera on board"),
                                Optional.of(List.of("ctd/temperature", "ctd/oxygen")))),
                new SettingsReport(new Gains(1.2, 0, 0), new Gains(0.3, 0, 0), 1, LostLinkAction.HOLD)
                        .with(new BoatCapabilities(Collections.emptyMap(), Optional.of(List.of()))),
                new SetWaysHome("c", "l", List.of(List.of(), List.of(List.of()), List.of(path, path.subList(0, 1)))),
                new SensorReport("ctd", "temperature", List.of(17.25, -1e300), "°C", 45.4, 10.9, 12),
                new ListFiles("r", KeptFile.LOG, "anna.log"),
                new FileList(
                        "r",
                        List.of(
                                new KeptFile("anna.log", KeptFile.LOG, 12, "0123456789abcdef".repeat(4)),
                                new KeptFile("bärbel 2.jpg", KeptFile.PICTURE, 200_000_000, "")),
                        true),
                new GetPiece("r", "../anna.log", Long.MAX_VALUE, FilePiece.MAX_BYTES),
                new FilePiece("r", "anna.log", 7, new byte[] {0, -1, 10, 127}),
                new FilePiece("r", "anna.log", Long.MAX_VALUE, new byte[FilePiece.MAX_BYTES]),
                new FileRefusal("r", FileRefusal.Reason.PAST_END, "anna.log has 7 bytes"));
    }

    @ParameterizedTest
    @MethodSource("messages")
    void givesBackWhatWasSent(LinkMessage message) throws LinkException {
        byte[] bytes = codec.encode(41, message);

        Frame frame = codec.decode(bytes);

        assertThat(frame.sequence()).isEqualTo(41);
        assertThat(frame.message())
                .hasSameClassAs(message)
                .usingRecursiveComparison()
                .isEqualTo(message);
        assertThat(codec.encode(41, frame.message())).isEqualTo(bytes);
    }

    @Test
    void tableAboveHoldsEveryKindOfMessage() {
        assertThat(messages().map(LinkMessage::type).collect(Collectors.toSet()))
                .isEqualTo(MessageReaders.types())
                .hasSize(40);
    }

    @Test
    void keepsEveryBitOfAPosition() throws LinkException {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 2000; i++) {
            Waypoint sent =
                    new Waypoint(random.nextDouble(-90, 90), random.nextDouble(-180, 180), random.nextDouble(50));
            byte[] bytes = codec.encode(i, new UploadWaypoints("c", "l", List.of(sent)));

            assertThat(((UploadWaypoints) codec.decode(bytes).message()).waypoints())
                    .containsExactly(sent);
        }
    }

    @Test
    void writesAFrameThatAPersonCanRead() {
        byte[] bytes = codec.encode(5, new StartWaypoints("m1-a2-boat1", "L1", 3));

        int header = LinkCodec.HEADER_BYTES;
        String body = new String(bytes, header, bytes.length - header, StandardCharsets.UTF_8);
        assertThat(header).isEqualTo(9);
        assertThat(bytes).startsWith(0, 0, 0, bytes.length - 4, 2);
        assertThat(body)
                .isEqualTo("{\"type\":\"start\",\"seq\":5,\"command\":\"m1-a2-boat1\",\"list\":\"L1\",\"index\":3}");
    }

    @Test
    void readsBodiesWithMembersThatItDoesNotKnow() throws LinkException {
        byte[] bytes =
                MalformedFrameTest.frame("{\"later\":[{\"x\":null}],\"type\":\"ack\",\"seq\":0,\"command\":\"c\"}");

        assertThat(((Ack) codec.decode(bytes).message()).commandId()).isEqualTo("c");
    }

    @Test
    void cutsFramesOutOfAStreamThatArrivesInPieces() throws Exception {
        ByteArrayOutputStream wire = new ByteArrayOutputStream();
        List<byte[]> sent = new ArrayList<>();
        List<Waypoint> longPath = new ArrayList<>();
        for (int i = 0; i < 10_000; i++) {
            longPath.add(new Waypoint(i / 1000.0, -i / 777.0, 1.5));
        }
        sent.add(codec.encode(0, new UploadWaypoints("c", "l", longPath)));
        messages().forEach(message -> sent.add(codec.encode(sent.size(), message)));
        for (byte[] frame : sent) {
            wire.write(frame);
        }

        FrameReader reader = new FrameReader(new Trickle(wire.toByteArray()), codec);
        List<byte[]> got = new ArrayList<>();
        for (var next = reader.next(); next.isPresent(); next = reader.next()) {
            got.add(next.get());
        }

        assertThat(got).containsExactlyElementsOf(sent);
    }

    @Test
    void refusesToMakeAFrameThatNobodyTakes() {
        LinkCodec small = new LinkCodec(100);

        assertThatThrownBy(() -> small.encode(0, new Nack("c", NackReason.STALE, "x".repeat(200))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("100");
    }

    @Test
    void refusesToMakeMessagesOfNonsense() {
        assertThatThrownBy(() -> new Waypoint(Double.NaN, 0, 1)).hasMessageContaining("lat");
        assertThatThrownBy(() -> new Waypoint(0, 180.001, 1)).hasMessageContaining("lon");
        assertThatThrownBy(() -> new Waypoint(0, 0, -1)).hasMessageContaining("speed");
        assertThatThrownBy(() -> new StopMotors("")).hasMessageContaining("command");
        assertThatThrownBy(() -> new Teleoperate(0, 1.1)).hasMessageContaining("rudder");
        assertThatThrownBy(() -> new Progress("l", -1, false)).hasMessageContaining("next");
        assertThatThrownBy(() -> new Gains(0, 0, 1000.5)).hasMessageContaining("d:");
        assertThatThrownBy(() -> reading(List.of())).hasMessageContaining("values");
        assertThatThrownBy(() -> reading(Collections.nCopies(65, 1.0))).hasMessageContaining("65");
        assertThatThrownBy(() -> reading(List.of(1.0, Double.NaN))).hasMessageContaining("values");
    }

    @Test
    void refusesTrafficOfNonsenseAndSaysWhere() {
        String row = "{\"boat\":\"b\",\"lat\":1,\"lon\":1,\"heading\":0,\"speed\":0,\"mode\":\"HOLD\",\"age\":%s}";
        String rows = String.format(row, 0) + "," + String.format(row, -1);

        assertThatThrownBy(() -> codec.decode(MalformedFrameTest.frame(traffic(rows))))
                .hasMessageContaining("/boats/1/age")
                .hasMessageContaining("negative");
        assertThatThrownBy(() -> codec.decode(MalformedFrameTest.frame(traffic("7"))))
                .hasMessageContaining("/boats/0");
        assertThatThrownBy(
                        () -> new Traffic(Collections.nCopies(65, new NearbyBoat("b", 1, 1, 0, 0, BoatMode.HOLD, 0))))
                .hasMessageContaining("65");
        assertThatThrownBy(() -> new NearbyBoat("b", 1, 1, 0, 0, BoatMode.HOLD, 0, 1, Double.NaN))
                .hasMessageContaining("toLon");
    }

    @Test
    void refusesEdgesOfNonsenseAndSaysWhere() {
        assertThatThrownBy(() -> codec.decode(MalformedFrameTest.frame(noGo(1, "[45,10,45,11],[45,10,91,11]"))))
                .hasMessageContaining("/noGo/edges/1")
                .hasMessageContaining("91");
        assertThatThrownBy(() -> codec.decode(MalformedFrameTest.frame(noGo(1, "[45,10,45]"))))
                .hasMessageContaining("/noGo/edges/0");
        assertThatThrownBy(() -> codec.decode(MalformedFrameTest.frame(noGo(-1, ""))))
                .hasMessageContaining("/noGo/keep");
        assertThatThrownBy(() -> new NoGoEdges(1, Collections.nCopies(65, new NoGoEdge(1, 1, 2, 2))))
                .hasMessageContaining("65");
    }

    private static String noGo(double keep, String rows) {
        return "{\"type\":\"traffic\",\"seq\":0,\"boats\":[],\"noGo\":{\"keep\":" + keep + ",\"edges\":[" + rows
                + "]}}";
    }

    private static String traffic(String rows) {
        return "{\"type\":\"traffic\",\"seq\":0,\"boats\":[" + rows + "]}";
    }

    private static SensorReport reading(List<Double> values) {
        return new SensorReport("ctd", "temperature", values, "°C", 45, 10, 0);
    }

    /** Gives few bytes at a time, as a slow link does. */
    private static final class Trickle extends ByteArrayInputStream {
        Trickle(byte[] bytes) {
            super(bytes);
        }

        @Override
        public synchronized int read(byte[] into, int offset, int length) {
            return super.read(into, offset, Math.min(length, 7));
        }
    }
}
