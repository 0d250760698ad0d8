package org.sami.spn.engine;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.sami.spn.engine.codec.CanonicalEncoder;

/**
 * Names a state by what it means: two states of one engine with equal keys have the same markings, pending occurrences, timers,
 * decisions and variables, and take all further inputs alike, whatever ids they gave and at whatever time they are. Effects then
 * differ in ids, times and, between root missions that do not depend on one another, in order.
 *
 * <p>Inputs in another order give equal keys where no rule reads that order. Tokens of one place stand in order of entry, pending
 * occurrences of one input event in order of arrival, timers that are due at one time in the order in which they started: there
 * another order is another state. Memory that handlers keep counts as it is; a time in it is not made relative.
 */
public final class StateKey {
    private static final VarHandle EIGHT_BYTES =
            MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);
    /** Odd, with bits in all places: the golden ratio times 2 to the 64. */
    private static final long MULTIPLIER = 0x9E3779B97F4A7C15L;

    private final byte[] bytes;
    private final int hash;

    private StateKey(byte[] bytes) {
        this.bytes = bytes;
        this.hash = hash(bytes);
    }

    /** Eight bytes at a time: keys are hundreds of bytes long, and searches make hundreds of thousands a second. */
    private static int hash(byte[] bytes) {
        long hash = bytes.length;
        int at = 0;
        for (; at <= bytes.length - Long.BYTES; at += Long.BYTES) {
            hash = (hash ^ (long) EIGHT_BYTES.get(bytes, at)) * MULTIPLIER;
            hash ^= hash >>> 32;
        }
        for (; at < bytes.length; at++) {
            hash = (hash ^ bytes[at]) * MULTIPLIER;
        }
        return Long.hashCode(hash);
    }

    /** The key of a state as it is now; between two steps only. */
    public static StateKey of(EngineState state) {
        return new StateKey(new CanonicalEncoder(state.net).write());
    }

    /** The canonical bytes. Their form is the engine's own and may change between versions: not for files. */
    public byte[] bytes() {
        return bytes.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof StateKey key && hash == key.hash && Arrays.equals(bytes, key.bytes);
    }

    @Override
    public int hashCode() {
        return hash;
    }

    @Override
    public String toString() {
        return "StateKey " + Integer.toHexString(hash) + " of " + bytes.length + " bytes";
    }
}
