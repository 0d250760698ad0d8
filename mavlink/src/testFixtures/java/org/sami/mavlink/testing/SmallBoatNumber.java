package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.AutopilotVersion;
import java.math.BigInteger;
import java.util.concurrent.atomic.AtomicInteger;

/** The number that the autopilot of a {@link SmallBoat} says: of each boat another one, until a test changes that. Safe for use by several threads. */
public final class SmallBoatNumber {
    private static final int BYTES = 18;
    private static final AtomicInteger MADE = new AtomicInteger();

    private final byte[] number = new byte[BYTES];

    SmallBoatNumber(int system) {
        number[0] = (byte) system;
        set(MADE.incrementAndGet());
    }

    /** It is this from now on. */
    public synchronized void set(int value) {
        number[1] = (byte) (value >> Byte.SIZE);
        number[2] = (byte) value;
    }

    /** It says none from now on. */
    public synchronized void forget() {
        java.util.Arrays.fill(number, (byte) 0);
    }

    synchronized AutopilotVersion message() {
        return AutopilotVersion.builder()
                .flightCustomVersion(new byte[Byte.SIZE])
                .middlewareCustomVersion(new byte[Byte.SIZE])
                .osCustomVersion(new byte[Byte.SIZE])
                .uid(BigInteger.ZERO)
                .uid2(number.clone())
                .build();
    }
}
