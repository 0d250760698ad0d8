package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.ByteArrayInputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.LinkException.Fault;

class MalformedFrameTest {
    private final LinkCodec codec = new LinkCodec();

    static byte[] frame(String body) {
        return frame(body.getBytes(StandardCharsets.UTF_8));
    }

    static byte[] frame(byte[] body) {
        byte[] frame = ByteBuffer.allocate(LinkCodec.HEADER_BYTES + body.length)
                .putInt(body.length + 5)
                .put((byte) LinkCodec.VERSION)
                .putInt(0)
                .put(body)
                .array();
        ByteBuffer.wrap(frame).putInt(LinkCodec.CHECK_AT, FrameCheck.of(frame));
        return frame;
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "SYNTAX       |               | ``",
                "SYNTAX       |               | []",
                "SYNTAX       |               | 7",
                "SYNTAX       |               | null",
                "SYNTAX       |               | {",
                "SYNTAX       |               | {} {}",
                "SYNTAX       |               | {'type':'ack'}",
                "SYNTAX       |               | {\"type\":\"ack\",\"type\":\"ack\",\"seq\":0,\"command\":\"c\"}",
                "BAD_VALUE    | /thrust       | {\"type\":\"teleop\",\"seq\":0,\"thrust\":NaN,\"rudder\":0}",
                "BAD_VALUE    | /thrust       | {\"type\":\"teleop\",\"seq\":0,\"thrust\":-Infinity,\"rudder\":0}",
                "WRONG_TYPE   | /seq          | {\"type\":\"ack\",\"command\":\"c\",\"seq\":NaN}",
                "BAD_VALUE    | /waypoints/0  | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[[NaN,2,3]]}",
                "BAD_VALUE    | /values       | {\"type\":\"reading\",\"seq\":0,\"sensor\":\"s\",\"channel\":\"c\",\"values\":[NaN],\"unit\":\"\",\"lat\":0,\"lon\":0,\"time\":0}",
                "SYNTAX       |               | {\"a\":[[[[[[[[[[[[1]]]]]]]]]]]]}",
                "MISSING      | /type         | {}",
                "WRONG_TYPE   | /type         | {\"type\":5}",
                "UNKNOWN_TYPE | /type         | {\"type\":\"self-destruct\",\"seq\":0}",
                "MISSING      | /command      | {\"type\":\"ack\",\"seq\":0}",
                "WRONG_TYPE   | /command      | {\"type\":\"ack\",\"seq\":0,\"command\":null}",
                "BAD_VALUE    | /command      | {\"type\":\"ack\",\"seq\":0,\"command\":\"\"}",
                "MISSING      | /seq          | {\"type\":\"ack\",\"command\":\"c\"}",
                "BAD_VALUE    | /seq          | {\"type\":\"ack\",\"command\":\"c\",\"seq\":-1}",
                "WRONG_TYPE   | /seq          | {\"type\":\"ack\",\"command\":\"c\",\"seq\":1.5}",
                "WRONG_TYPE   | /seq          | {\"type\":\"ack\",\"command\":\"c\",\"seq\":99999999999999999999}",
                "BAD_VALUE    | /index        | {\"type\":\"start\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"index\":2147483648}",
                "BAD_VALUE    | /index        | {\"type\":\"start\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"index\":-1}",
                "BAD_VALUE    | /thrust       | {\"type\":\"teleop\",\"seq\":0,\"thrust\":1e400,\"rudder\":0}",
                "BAD_VALUE    | /rudder       | {\"type\":\"teleop\",\"seq\":0,\"thrust\":0,\"rudder\":-2}",
                "WRONG_TYPE   | /rudder       | {\"type\":\"teleop\",\"seq\":0,\"thrust\":0,\"rudder\":\"0\"}",
                "BAD_VALUE    | /role         | {\"type\":\"hello\",\"seq\":0,\"boat\":\"b\",\"client\":\"c\",\"role\":\"captain\",\"telemetryHz\":1,\"auth\":\"\"}",
                "WRONG_TYPE   | /completed    | {\"type\":\"progress\",\"seq\":0,\"list\":\"l\",\"next\":0,\"completed\":0}",
                "MISSING      | /waypoints    | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\"}",
                "WRONG_TYPE   | /waypoints    | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":{}}",
                "WRONG_TYPE   | /waypoints/0  | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[7]}",
                "WRONG_TYPE   | /waypoints/1  | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[[1,2,3],[1,2]]}",
                "WRONG_TYPE   | /waypoints/0/2| {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[[1,2,null]]}",
                "BAD_VALUE    | /waypoints/1  | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[[1,2,3],[91,2,3]]}",
                "BAD_VALUE    | /waypoints/0  | {\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[[1,2,-3]]}",
                "BAD_VALUE    | /p            | {\"type\":\"gains\",\"seq\":0,\"command\":\"c\",\"axis\":\"SPEED\",\"p\":1001,\"i\":0,\"d\":0}",
                "BAD_VALUE    | /multiplier   | {\"type\":\"velocity\",\"seq\":0,\"command\":\"c\",\"multiplier\":10.5}",
                "WRONG_TYPE   | /heading      | {\"type\":\"settings\",\"seq\":0,\"heading\":3}",
                "MISSING      | /heading/d    | {\"type\":\"settings\",\"seq\":0,\"heading\":{\"p\":1,\"i\":0}}",
                "BAD_VALUE    | /heading/i    | {\"type\":\"settings\",\"seq\":0,\"heading\":{\"p\":1,\"i\":-1,\"d\":0}}",
                "WRONG_TYPE   | /values/1     | {\"type\":\"reading\",\"seq\":0,\"values\":[1,\"2\"]}",
                "BAD_VALUE    | /values       | {\"type\":\"reading\",\"seq\":0,\"sensor\":\"s\",\"channel\":\"c\",\"values\":[],\"unit\":\"\",\"lat\":0,\"lon\":0,\"time\":0}",
            })
    void saysWhatIsWrongAndWhere(Fault fault, String where, String body) {
        LinkException thrown = catchThrowableOfType(LinkException.class, () -> codec.decode(frame(body)));

        assertThat(thrown.fault()).isEqualTo(fault);
        assertThat(thrown.where()).isEqualTo(where == null ? "" : where);
    }

    @Test
    void namesTheCommandThatItRefuses() {
        byte[] bytes =
                frame("{\"type\":\"upload\",\"seq\":0,\"command\":\"m1-a1\",\"list\":\"l\",\"waypoints\":[[95,0,1]]}");

        LinkException thrown = catchThrowableOfType(LinkException.class, () -> codec.decode(bytes));

        assertThat(thrown.commandId()).isEqualTo("m1-a1");
        assertThat(thrown).hasMessageContaining("/waypoints/0").hasMessageContaining("95");
    }

    @Test
    void refusesIdsAndTextsWithoutEnd() {
        String id = "x".repeat(Checks.MAX_ID_LENGTH + 1);
        String text = "x".repeat(100_000);

        assertFault(Fault.BAD_VALUE, frame("{\"type\":\"ack\",\"seq\":0,\"command\":\"" + id + "\"}"));
        assertFault(Fault.SYNTAX, frame("{\"type\":\"ack\",\"seq\":0,\"command\":\"" + text + "\"}"));
    }

    @ParameterizedTest
    @CsvSource({"-1", "0", "2147483647", "-2147483648", "4194305"})
    void refusesDeclaredLengthsOutOfBounds(int declared) {
        byte[] bytes = ByteBuffer.allocate(10).putInt(declared).array();

        assertFault(Fault.LENGTH, bytes);
        assertThatThrownBy(() -> new FrameReader(new ByteArrayInputStream(bytes), codec).next())
                .isInstanceOfSatisfying(
                        LinkException.class, e -> assertThat(e.fault()).isEqualTo(Fault.LENGTH));
    }

    @Test
    void refusesOtherVersions() {
        byte[] bytes = codec.encode(0, new Ack("c"));
        for (int version : new int[] {0, 1, 3, 255}) {
            bytes[4] = (byte) version;

            assertFault(Fault.VERSION, bytes);
            assertThat(LinkCodec.versionOf(bytes)).isEqualTo(version);
        }
    }

    @ParameterizedTest
    @CsvSource({"c0 af", "ed a0 80", "ff", "e2 82", "f4 90 80 80", "0"})
    void refusesWhatIsNotStrictUtf8(String hex) {
        byte[] good = "{\"type\":\"ack\",\"seq\":0,\"command\":\"____\"}".getBytes(StandardCharsets.UTF_8);
        int at = good.length - 6;
        for (String octet : hex.split(" ")) {
            good[at++] = (byte) Integer.parseInt(octet, 16);
        }

        assertFault(Fault.ENCODING, frame(good));
    }

    @Test
    void refusesOtherEncodings() {
        String body = "{\"type\":\"ack\",\"seq\":0,\"command\":\"c\"}";

        assertFault(Fault.ENCODING, frame(body.getBytes(StandardCharsets.UTF_16LE)));
        assertFault(Fault.ENCODING, frame(body.getBytes(StandardCharsets.UTF_16)));
    }

    @Test
    void refusesEveryPrefixOfEveryMessage() {
        RoundTripTest.messages().forEach(message -> {
            byte[] whole = codec.encode(1, message);
            for (int length = 0; length < whole.length; length++) {
                byte[] prefix = Arrays.copyOf(whole, length);
                assertFault(Fault.TRUNCATED, prefix);
                assertPrefixEndsStream(prefix);
            }
        });
    }

    private void assertPrefixEndsStream(byte[] prefix) {
        FrameReader reader = new FrameReader(new ByteArrayInputStream(prefix), codec);
        if (prefix.length == 0) {
            assertThat(assertDoesNotThrow(reader)).isFalse();
        } else {
            assertThatThrownBy(reader::next)
                    .isInstanceOfSatisfying(
                            LinkException.class, e -> assertThat(e.fault()).isEqualTo(Fault.TRUNCATED));
        }
    }

    private static boolean assertDoesNotThrow(FrameReader reader) {
        try {
            return reader.next().isPresent();
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void bentBodiesUnderARightCheckValueNeitherCrashNorPassUnchecked() {
        SplittableRandom random = new SplittableRandom(11);
        List<LinkMessage> messages = RoundTripTest.messages().toList();
        int refused = 0;
        for (int i = 0; i < 20_000; i++) {
            byte[] body = LinkCodec.body(messages.get(i % messages.size()));
            for (int flips = random.nextInt(1, 4); flips > 0; flips--) {
                body[random.nextInt(body.length)] ^= (byte) (1 << random.nextInt(8));
            }
            refused += isRefused(frame(body)) ? 1 : 0;
        }
        byte[] noise = new byte[2 << 20];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = (byte) random.nextInt();
        }

        assertThat(refused).isGreaterThan(10_000);
        assertThat(isRefused(noise)).isTrue();
        assertThat(isRefused(frame(noise))).isTrue();
    }

    /** Whether it is refused; what is taken is a message whose own checks have passed. */
    private boolean isRefused(byte[] bytes) {
        try {
            codec.decode(bytes);
            return false;
        } catch (LinkException e) {
            return true;
        }
    }

    private void assertFault(Fault fault, byte[] bytes) {
        assertThatThrownBy(() -> codec.decode(bytes))
                .isInstanceOfSatisfying(
                        LinkException.class, e -> assertThat(e.fault()).isEqualTo(fault));
    }
}
