package org.sami.crw.mavlink;

import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.SigningKey;

/**
 * The key with which a running gateway signs: the one that this base keeps, also after it was replaced meanwhile. For one thread at a time.
 */
final class FleetKeyInUse {
    private static final System.Logger LOG = System.getLogger(FleetKeyInUse.class.getName());

    private final Supplier<Optional<SigningKey>> kept;
    private final Optional<LinkSigning> signing;
    private Optional<SigningKey> made = Optional.empty(); // after a gateway without one had begun
    private String fault = "";

    /**
     * Reads the key.
     *
     * @param kept reads it where it is kept; throws an {@link IllegalStateException} in words where it cannot be read
     */
    FleetKeyInUse(Supplier<Optional<SigningKey>> kept) {
        this.kept = Objects.requireNonNull(kept, "kept");
        signing = kept.get().map(key -> new LinkSigning(key, Instant::now, LinkSigning.Unsigned.TAKEN_UNTIL_SIGNED));
    }

    /** How links sign; empty where there was no key at the beginning. */
    Optional<LinkSigning> signing() {
        return signing;
    }

    /** Reads the key again. One that cannot be read, or is there no longer, leaves the one in use. */
    void reread() {
        try {
            kept.get().ifPresent(this::take);
            fault = "";
        } catch (IllegalStateException e) {
            String words = String.valueOf(e.getMessage());
            if (!words.equals(fault)) {
                LOG.log(Level.WARNING, words + "; links go on with the one in use");
            }
            fault = words;
        }
    }

    private void take(SigningKey key) {
        if (signing.isEmpty()) {
            made = Optional.of(key);
        } else if (!signing.get().key().isSame(key)) {
            signing.get().renew(key);
        }
    }

    /** What the operator has to know of the key on the links to a vehicle; empty where it is the one that this base keeps. */
    Optional<String> warning(int system, String name) {
        Optional<String> former = signing.filter(use -> use.isSigningWithFormer(system))
                .map(use -> "The key of the fleet was replaced by " + use.key().fingerprint() + "; links to " + name
                        + " go on with the one before it until it is given the new one over its cable (crw keys fleet"
                        + " --give ADDRESS). A session that starts now does not reach it before");
        return former.or(() -> made.map(key -> "The key of the fleet, " + key.fingerprint()
                + ", was made after this session began, which therefore signs nothing that it sends to " + name
                + ": start it anew before you give vehicles the key"));
    }
}
