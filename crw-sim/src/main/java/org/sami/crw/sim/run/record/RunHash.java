package org.sami.crw.sim.run.record;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.sami.spn.protocol.Effect;

/**
 * SHA-256 over a run: every firing and activation with its ids, values and simulated time, and the boats' true final positions to the millimetre. Two
 * runs are equal if and only if their hashes are, whatever their speed and however often they were killed and resumed.
 */
public final class RunHash {
    private final MessageDigest digest = sha256();

    public static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    /** Adds the effects of one input. */
    public void add(long atMillis, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired || effect instanceof Effect.Activated) {
                line(atMillis + " " + effect);
            }
        }
    }

    /** The hash of everything so far and of these positions; later additions do not change it. */
    public String with(List<BoatState> boats) {
        try {
            MessageDigest end = (MessageDigest) digest.clone();
            boats.forEach(boat ->
                    end.update((boat.id() + " " + boat.toTheMillimetre() + "\n").getBytes(StandardCharsets.UTF_8)));
            return HexFormat.of().formatHex(end.digest());
        } catch (CloneNotSupportedException e) {
            throw new IllegalStateException("the JDK's SHA-256 can be cloned", e);
        }
    }

    private void line(String text) {
        digest.update((text + "\n").getBytes(StandardCharsets.UTF_8));
    }
}
