package org.sami.crw.sim.run.record;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import org.sami.spn.protocol.Effect;

/**
 * SHA-256 over a run: every firing and activation with its ids, values and simulated time, and at the end the boats'
 * true positions to the millimetre. Runs are equal if and only if their hashes are, whatever their speed and however
 * often they were killed and taken up again.
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

    /** Takes in what followed from one input. */
    void add(long atMillis, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Fired || effect instanceof Effect.Activated) {
                line(atMillis + " " + effect);
            }
        }
    }

    /** The hash of everything so far and of these positions; what is added later does not change it. */
    String with(List<BoatState> boats) {
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
