package org.sami.mavlink.link;

import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;

/**
 * Signs what a base or boat sends, and refuses what is not signed as it must be. One for all links of a base, so that a recording of one link is refused on
 * another. Safe for use by several threads.
 *
 * <p>Source: "Message Signing" of MAVLink's documentation. A base that has just started cannot recognize the repetition
 * of a message of the last minute; the protocol has the same limit.
 */
public final class LinkSigning {
    private static final long A_MINUTE = 6_000_000; // of signatures' time

    private final SigningKey key;
    private final Unsigned unsigned;
    private final SigningClock clock;
    private final Map<Stream, Long> last = new HashMap<>();
    private final Set<Integer> signed = new HashSet<>(); // systems that have signed with the key

    /** What becomes of messages without a signature. */
    public enum Unsigned {
        /** All are taken, also those with the signature of another key, as of the one before: while vehicles are given the key. */
        TAKEN,
        /** Accepted from vehicles that have not signed with the key yet: some vehicles of the fleet may not have it. */
        TAKEN_UNTIL_SIGNED,
        /** None is taken. */
        REFUSED
    }

    /** Messages of one component on one link of it. */
    private record Stream(int link, int system, int component) {}

    /**
     * Signing with a key.
     *
     * @param now the time of day
     * @param unsigned what becomes of messages without a signature
     */
    public LinkSigning(SigningKey key, Supplier<Instant> now, Unsigned unsigned) {
        this.key = Objects.requireNonNull(key, "key");
        this.unsigned = Objects.requireNonNull(unsigned, "unsigned");
        clock = new SigningClock(now);
    }

    /** The key. */
    public SigningKey key() {
        return key;
    }

    /** A time for a message that is signed now, in tens of microseconds since 2015. */
    public long nextTime() {
        return clock.next();
    }

    /** Why a packet is refused; empty where it is taken. A radio's own report, which radios cannot sign, is taken: nothing but strengths is read from it. */
    Optional<SignatureFault> fault(MavlinkPacket packet) {
        if (!isSigned(packet)) {
            return packet.getMessageId() == LinkSenders.RADIO_STATUS || takesUnsigned(packet.getSystemId())
                    ? Optional.empty()
                    : Optional.of(SignatureFault.UNSIGNED);
        }
        if (!packet.validateSignature(key.secret())) {
            return unsigned == Unsigned.TAKEN ? Optional.empty() : Optional.of(SignatureFault.WRONG);
        }
        return faultOfTime(
                new Stream(packet.getSignatureLinkId(), packet.getSystemId(), packet.getComponentId()),
                packet.getSignatureTimestamp());
    }

    /** Whether a packet that was taken is signed with the key. */
    boolean isOurs(MavlinkPacket packet) {
        return isSigned(packet) && (unsigned != Unsigned.TAKEN || packet.validateSignature(key.secret()));
    }

    /** Whether a packet has a signature, right or wrong. */
    static boolean isSigned(MavlinkPacket packet) {
        return packet.isMavlink2() && packet.isSigned();
    }

    private synchronized boolean takesUnsigned(int system) {
        return switch (unsigned) {
            case TAKEN -> true;
            case TAKEN_UNTIL_SIGNED -> !signed.contains(system);
            case REFUSED -> false;
        };
    }

    private synchronized Optional<SignatureFault> faultOfTime(Stream stream, long time) {
        Long before = last.get(stream);
        if (before == null && time + A_MINUTE < clock.present()) {
            return Optional.of(SignatureFault.OLD);
        }
        if (before != null && time <= before) {
            return Optional.of(time + A_MINUTE < before ? SignatureFault.OLD : SignatureFault.REPLAYED);
        }
        last.put(stream, time);
        signed.add(stream.system);
        clock.heard(time);
        return Optional.empty();
    }
}
