package org.sami.mavlink.link;

import io.dronefleet.mavlink.protocol.MavlinkPacket;
import io.dronefleet.mavlink.protocol.MavlinkPacketReader;
import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.sami.mavlink.format.MessageFormat;
import org.sami.mavlink.format.MessageFormats;

/**
 * Reads packets of known kinds with right checksums from bytes, whatever else is among them, and the messages in those of some kinds; of other kinds it may say that they came. Used by one thread, but
 * for {@link #bytes}.
 */
public final class MessageReader {
    private final ReadAhead in;
    private final MavlinkPacketReader packets;
    private final Predicate<Class<?>> isRead;
    private final Predicate<MavlinkPacket> isExpected;
    private final Map<Integer, Kind> kinds = new HashMap<>(); // that came, by their numbers

    /** A kind of messages, and whether they are read. */
    private record Kind(MessageFormat format, boolean isRead) {}

    /**
     * A reader.
     *
     * @param isRead of which of the library's classes messages are read; of others only the packets
     */
    public MessageReader(InputStream from, Predicate<Class<?>> isRead) {
        this(from, isRead, packet -> false, () -> {});
    }

    /**
     * A reader that says when it waits.
     *
     * @param isRead of which of the library's classes messages are read; of others only the packets
     * @param isExpected whether a packet of a kind that is not known, whose checksum so tells nothing, counts as one that came
     * @param beforeWaiting called within {@link #next} before it waits for more bytes
     */
    MessageReader(
            InputStream from, Predicate<Class<?>> isRead, Predicate<MavlinkPacket> isExpected, Runnable beforeWaiting) {
        this.isExpected = isExpected;
        in = new ReadAhead(from, beforeWaiting);
        packets = new MavlinkPacketReader(in);
        this.isRead = isRead;
    }

    /** How many bytes came so far. For any thread. */
    long bytes() {
        return in.bytes();
    }

    /** The first characters that came, some eight; empty where none came. For any thread. */
    String first() {
        return in.first();
    }

    /**
     * Waits for the next packet.
     *
     * @throws java.io.EOFException if there is none any more
     */
    public MavlinkPacket next() throws IOException {
        while (true) {
            MavlinkPacket packet = packets.next();
            Optional<Kind> kind = kind(packet.getMessageId());
            if (kind.isPresent() && packet.validateCrc(kind.get().format.checksumExtra())) {
                return packet;
            }
            packets.drop(); // goes on with its second byte: a packet may begin within it
            if (kind.isEmpty() && isExpected.test(packet)) {
                return packet;
            }
        }
    }

    private Optional<Kind> kind(int number) {
        Optional<Kind> known = Optional.ofNullable(kinds.get(number));
        if (known.isEmpty()) {
            known = MessageFormats.of(number).map(format -> new Kind(format, isRead.test(format.kind())));
            known.ifPresent(kind -> kinds.put(number, kind));
        }
        return known;
    }

    /** The message of a packet that {@link #next} returned, or {@link ReceivedMessage#UNREAD}. */
    public Object message(MavlinkPacket packet) {
        return kind(packet.getMessageId())
                .filter(Kind::isRead)
                .map(kind -> kind.format.read(packet.getPayload()))
                .orElse(ReceivedMessage.UNREAD);
    }
}
