package org.sami.mavlink.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.common.Attitude;
import io.dronefleet.mavlink.common.MissionCurrent;
import io.dronefleet.mavlink.common.MissionState;
import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

class MessageReaderTest {
    private static byte[] packets(Object... payloads) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MavlinkConnection codec = MavlinkConnection.create(InputStream.nullInputStream(), bytes);
        for (Object payload : payloads) {
            codec.send2(1, 1, payload);
        }
        return bytes.toByteArray();
    }

    private static Object current(int item) {
        return MissionCurrent.builder()
                .seq(item)
                .missionState(MissionState.MISSION_STATE_ACTIVE)
                .build();
    }

    private static Object attitude() {
        return Attitude.builder().timeBootMs(7).build();
    }

    @Test
    void onlyMessagesOfAskedKindsAreRead() throws Exception {
        MessageReader reader = new MessageReader(
                new ByteArrayInputStream(packets(current(3), attitude(), current(4))),
                kind -> kind == MissionCurrent.class);

        List<Object> read = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            MavlinkPacket packet = reader.next();
            assertThat(packet.getSequence()).isEqualTo(i);
            read.add(reader.message(packet));
        }

        assertThat(read).containsExactly(current(3), ReceivedMessage.UNREAD, current(4));
        assertThatThrownBy(reader::next).isInstanceOf(EOFException.class);
    }

    /** As those of newer firmware, or of a maker's own. */
    @Test
    void messagesOfUnknownKindsCountAsOnesThatCame() throws Exception {
        SequenceCount count = new SequenceCount();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        MavlinkConnection codec = MavlinkConnection.create(InputStream.nullInputStream(), bytes);
        for (int i = 0; i < 50; i++) {
            codec.send2(1, 1, current(i));
            int begin = bytes.size();
            codec.send2(1, 1, attitude());
            byte[] all = bytes.toByteArray();
            all[begin + 7] = (byte) 0xf0; // another kind, for which its checksum is not known
            all[begin + 8] = (byte) 0xf0;
            bytes.reset();
            bytes.write(all);
        }
        MessageReader reader = new MessageReader(
                new ByteArrayInputStream(bytes.toByteArray()),
                kind -> true,
                packet -> count.isNext(packet.getSystemId(), packet.getComponentId(), packet.getSequence()),
                () -> {});

        for (int i = 0; i < 100; i++) {
            MavlinkPacket packet = reader.next();
            count.came(packet.getSystemId(), packet.getComponentId(), packet.getSequence());
            assertThat(reader.message(packet)).isEqualTo(i % 2 == 0 ? current(i / 2) : ReceivedMessage.UNREAD);
        }

        assertThat(count.lost()).isZero();
    }

    @Test
    void packetsAmongRubbishAreFoundWhereverReadsCutThem() throws Exception {
        SplittableRandom random = new SplittableRandom(3);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        for (int i = 0; i < 200; i++) {
            byte[] rubbish = new byte[random.nextInt(20)];
            random.nextBytes(rubbish);
            bytes.write(rubbish);
            byte[] packet = packets(current(i));
            bytes.write(packet);
            packet[packet.length - 1] ^= 1; // its checksum is wrong
            bytes.write(packet);
        }
        bytes.write(new byte[300]); // as a packet may seem to begin in the last rubbish
        MessageReader reader =
                new MessageReader(new Pieces(bytes.toByteArray(), random), kind -> kind == MissionCurrent.class);

        for (int i = 0; i < 200; i++) {
            assertThat(reader.message(reader.next())).isEqualTo(current(i));
        }
        assertThatThrownBy(reader::next).isInstanceOf(EOFException.class);
    }

    /** Gives a few bytes at a time. */
    private static final class Pieces extends InputStream {
        private final ByteArrayInputStream all;
        private final SplittableRandom random;

        Pieces(byte[] all, SplittableRandom random) {
            this.all = new ByteArrayInputStream(all);
            this.random = random;
        }

        @Override
        public int read() {
            return all.read();
        }

        @Override
        public int read(byte[] to, int from, int length) {
            return all.read(to, from, Math.min(length, 1 + random.nextInt(9)));
        }
    }

    @Test
    void linkCountsAndHandsOverInOrderWhatIsNotReadToo() throws Exception {
        List<ReceivedMessage> came = new CopyOnWriteArrayList<>();
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            MavlinkAddress address = AddressText.parse("mavlink:tcp:127.0.0.1:" + server.getLocalPort());
            try (MavlinkLink link = new MavlinkLink(
                    address,
                    (from, messages) -> came.addAll(messages),
                    LinkEnd.ground(),
                    kind -> kind == MissionCurrent.class)) {
                link.start();
                try (Socket socket = server.accept()) {
                    OutputStream out = socket.getOutputStream();
                    byte[] all = packets(attitude(), attitude(), attitude(), current(3));
                    int each = packets(attitude()).length;
                    out.write(all, 0, each); // the second is lost
                    out.write(all, 2 * each, all.length - 2 * each);
                    Await.until("all have come", () -> came.size() == 3);
                }
                assertThat(link.report().messages()).isEqualTo(3);
                assertThat(link.report().lost()).isEqualTo(1.0 / 4);
            }
        }
        assertThat(came).extracting(ReceivedMessage::number).containsExactly(0, 2, 3);
        assertThat(came)
                .extracting(ReceivedMessage::payload)
                .containsExactly(ReceivedMessage.UNREAD, ReceivedMessage.UNREAD, current(3));
    }

    /** A packet of a kind that is in no dialect, as a maker's own; so its checksum cannot be right. */
    private static byte[] packetOfUnknownKind() throws IOException {
        byte[] packet = packets(attitude());
        packet[7] = packet[8] = packet[9] = (byte) 0xee; // its number
        return packet;
    }

    @Test
    void messageDoesNotWaitForWhatComesAfterAPacketOfUnknownKind() throws Exception {
        List<ReceivedMessage> came = new CopyOnWriteArrayList<>();
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                MavlinkLink link = new MavlinkLink(
                        AddressText.parse("mavlink:tcp:127.0.0.1:" + server.getLocalPort()),
                        (from, messages) -> came.addAll(messages),
                        LinkEnd.ground(),
                        kind -> kind == MissionCurrent.class)) {
            link.start();
            try (Socket socket = server.accept()) {
                ByteArrayOutputStream together = new ByteArrayOutputStream();
                together.write(packets(current(3)));
                together.write(packetOfUnknownKind());
                socket.getOutputStream().write(together.toByteArray());

                Await.until("the message has come", () -> !came.isEmpty());
            }
        }
        assertThat(came).extracting(ReceivedMessage::payload).containsExactly(current(3));
    }
}
