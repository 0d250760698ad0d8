package org.sami.spn.stepping;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.Set;
import org.sami.spn.engine.AlikeKey;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateKey;

/**
 * Names a moment of a run by what it means, in a few bytes: two moments with equal keys go on alike, whatever ids were given and at whatever
 * time they are ({@link StateKey}).
 */
public final class MomentKey {
    private final byte[] digest;
    private final int bytes;

    private MomentKey(byte[] digest, int bytes) {
        this.digest = digest;
        this.bytes = bytes;
    }

    static MomentKey of(EngineState now, RobotTasks tasks) {
        byte[] state = StateKey.of(now).bytes();
        MessageDigest sha = sha256();
        sha.update(state);
        sha.update(tasks.words().getBytes(StandardCharsets.UTF_8));
        return new MomentKey(sha.digest(), state.length);
    }

    /** The key of a moment but for which robot and made task is which, points, and how long timers run ({@link AlikeKey}). */
    static MomentKey alike(EngineState now, RobotTasks tasks, Set<String> robots) {
        AlikeKey key = AlikeKey.of(now, robots);
        tasks.addTo(key);
        byte[] state = key.bytes();
        return new MomentKey(sha256().digest(state), state.length);
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e); // every Java has it
        }
    }

    /** How many bytes the moment's state has in its shortest form: a measure of the memory that it needs. */
    public int stateBytes() {
        return bytes;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof MomentKey key && Arrays.equals(digest, key.digest);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(digest);
    }

    @Override
    public String toString() {
        return "MomentKey " + Integer.toHexString(hashCode());
    }
}
