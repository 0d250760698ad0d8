package org.sami.mavlink.link;

import io.dronefleet.mavlink.protocol.MavlinkPacket;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Signs what a base or boat sends, and refuses what is not signed as it must be. One for all links of a base, so that a recording of one link is refused on
 * another. The key can be replaced: a system that has signed with one before it is spoken to with that one until it signs with the present one, so that no
 * vehicle under way is lost. Safe for use by several threads.
 *
 * <p>Source: "Message Signing" of MAVLink's documentation. A base that has just started cannot recognize the repetition
 * of a message of the last minute; the protocol has the same limit.
 */
public final class LinkSigning {
    private static final long A_MINUTE = 6_000_000; // of signatures' time

    /** As the system of a message for all. */
    public static final int EVERYBODY = 0;

    private volatile SigningKey key;
    private final Unsigned unsigned;
    private final SigningClock clock;
    private final Map<Stream, Long> last = new HashMap<>();
    private final Map<Integer, SigningKey> signed = new HashMap<>(); // the key with which each system has signed last

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

    /** The present key. */
    public SigningKey key() {
        return key;
    }

    /** Takes another key in place of the present one; who has signed with that one goes on with it until it signs with the other. */
    public void renew(SigningKey next) {
        key = Objects.requireNonNull(next, "next");
    }

    /** Whether a system has signed, and last with a key before the present one. */
    public synchronized boolean isSigningWithFormer(int system) {
        return Optional.ofNullable(signed.get(system))
                .filter(last -> !last.isSame(key))
                .isPresent();
    }

    /**
     * The keys with which a message is signed: one for a message to one system; for {@link #EVERYBODY} the present one and each with which a system still signs.
     */
    synchronized List<SigningKey> keysTo(int system) {
        if (system != EVERYBODY) {
            return List.of(signed.getOrDefault(system, key));
        }
        List<SigningKey> keys = new ArrayList<>(List.of(key));
        signed.values().stream()
                .filter(other -> keys.stream().noneMatch(other::isSame))
                .forEach(keys::add);
        return keys;
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
        Optional<SigningKey> with = keyOf(packet);
        if (with.isEmpty()) {
            return unsigned == Unsigned.TAKEN ? Optional.empty() : Optional.of(SignatureFault.WRONG);
        }
        return faultOfTime(
                new Stream(packet.getSignatureLinkId(), packet.getSystemId(), packet.getComponentId()),
                packet.getSignatureTimestamp(),
                with.get());
    }

    /** The key with which a packet is signed: the present one, or the one before it with which its system has signed last. */
    private Optional<SigningKey> keyOf(MavlinkPacket packet) {
        SigningKey present = key;
        if (packet.validateSignature(present.secret())) {
            return Optional.of(present);
        }
        Optional<SigningKey> last;
        synchronized (this) {
            last = Optional.ofNullable(signed.get(packet.getSystemId()));
        }
        return last.filter(former -> !former.isSame(present) && packet.validateSignature(former.secret()));
    }

    /** Whether a packet that was taken is signed with the present key. */
    boolean isOurs(MavlinkPacket packet) {
        return isSigned(packet)
                && (unsigned == Unsigned.TAKEN
                        ? packet.validateSignature(key.secret())
                        : !isSigningWithFormer(packet.getSystemId()));
    }

    /** Whether a packet has a signature, right or wrong. */
    static boolean isSigned(MavlinkPacket packet) {
        return packet.isMavlink2() && packet.isSigned();
    }

    private synchronized boolean takesUnsigned(int system) {
        return switch (unsigned) {
            case TAKEN -> true;
            case TAKEN_UNTIL_SIGNED -> !signed.containsKey(system);
            case REFUSED -> false;
        };
    }

    private synchronized Optional<SignatureFault> faultOfTime(Stream stream, long time, SigningKey with) {
        Long before = last.get(stream);
        if (before == null && time + A_MINUTE < clock.present()) {
            return Optional.of(SignatureFault.OLD);
        }
        if (before != null && time <= before) {
            return Optional.of(time + A_MINUTE < before ? SignatureFault.OLD : SignatureFault.REPLAYED);
        }
        last.put(stream, time);
        signed.put(stream.system, with);
        clock.heard(time);
        return Optional.empty();
    }
}
