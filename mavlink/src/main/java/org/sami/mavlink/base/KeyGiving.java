package org.sami.mavlink.base;

import io.dronefleet.mavlink.common.SetupSigning;
import java.math.BigInteger;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.vehicle.VehicleId;

/** Sends one vehicle the signing key until it signs with it: the protocol has no answer to that message. Used by one thread. */
final class KeyGiving {
    private static final long AGAIN_MS = 1_500;
    private static final int TRIES = 6;

    private final VehicleId vehicle;
    private final LinkSigning signing;
    private final Consumer<Object> send;
    private final CompletableFuture<Void> result = new CompletableFuture<>();
    private int tries;
    private long sentMs;

    KeyGiving(VehicleId vehicle, LinkSigning signing, Consumer<Object> send) {
        this.vehicle = vehicle;
        this.signing = signing;
        this.send = send;
    }

    CompletableFuture<Void> begin(long nowMs) {
        if (tries == 0) {
            give(nowMs);
        }
        return result;
    }

    private void give(long nowMs) {
        tries++;
        sentMs = nowMs;
        send.accept(SetupSigning.builder()
                .targetSystem(vehicle.system())
                .targetComponent(vehicle.component())
                .secretKey(signing.key().secret())
                .initialTimestamp(BigInteger.valueOf(signing.nextTime()))
                .build());
    }

    /** The vehicle sent a message with a valid signature. */
    void signed() {
        result.complete(null);
    }

    /** Another vehicle answers with its id: it gets no key unasked. */
    void replaced() {
        result.completeExceptionally(new IllegalStateException("another vehicle answers as vehicle " + vehicle));
    }

    /** Sends the key again if that is due. Returns whether the exchange is over. */
    boolean tick(long nowMs) {
        if (!result.isDone() && nowMs >= sentMs + AGAIN_MS) {
            if (tries == TRIES) {
                result.completeExceptionally(new IllegalStateException("vehicle " + vehicle
                        + " does not sign with the key: autopilots take one only on a cable, and older"
                        + " ones take none"));
            } else {
                give(nowMs);
            }
        }
        return result.isDone();
    }
}
