package org.sami.boat.link.security;

import java.io.IOException;
import java.util.Optional;
import org.sami.boat.link.Role;

/**
 * A boat's part in pairing: it shows words for some minutes, and keeps the key of the one base that proves to know them. The words count once; after five wrong
 * proofs nobody is paired before new words are shown. Safe for use by several threads.
 */
public final class PairingResponder {
    /** How long words count, in ms. */
    public static final long OPEN_MS = 5 * 60_000;

    private static final int MOST_WRONG = 5;

    /** Gets to know who was paired. */
    public interface Listener {
        /** A base was paired; both sides show the code, which differs if somebody is in between. */
        void paired(Peer base, String checkCode);
    }

    private final KeyRing keys;
    private final Listener listener;
    private Optional<PairingSecret> secret = Optional.empty();
    private Role role = Role.COMMANDER;
    private long untilMs;
    private int wrong;
    private String closed = "the boat shows no words: begin the pairing at the boat";

    /** Pairs nobody before words are shown. */
    public PairingResponder(KeyRing keys) {
        this(keys, (base, code) -> {});
    }

    /** Pairs nobody before words are shown; the listener is called on the thread that pairs. */
    public PairingResponder(KeyRing keys, Listener listener) {
        this.keys = keys;
        this.listener = listener;
    }

    /** Begins to pair one base, which gets that role. The words replace earlier ones. */
    public synchronized PairingSecret open(Role granted, long nowMs) {
        PairingSecret words = PairingSecret.random();
        secret = Optional.of(words);
        role = granted;
        untilMs = nowMs + OPEN_MS;
        wrong = 0;
        return words;
    }

    /** Whether words are shown that count. */
    public synchronized boolean isOpen(long nowMs) {
        return secret.isPresent() && nowMs < untilMs;
    }

    /**
     * Takes a base's proof, and keeps its key if it is right.
     *
     * @param name under which the key is kept
     * @return the boat's own proof
     * @throws LinkRefusedException with the reason, if the base is not paired
     * @throws IOException if the key cannot be kept
     */
    public String pair(Fingerprint base, String name, String proof, long nowMs) throws IOException {
        return pair(base, name, proof, Role.COMMANDER, nowMs);
    }

    /**
     * The same for a base that may wish for less than the boat would grant.
     *
     * @param wished the most that it is to be granted
     */
    public synchronized String pair(Fingerprint base, String name, String proof, Role wished, long nowMs)
            throws IOException {
        if (secret.isPresent() && nowMs >= untilMs) {
            close("the words count no longer: begin the pairing anew at the boat");
        }
        PairingSecret words = secret.orElseThrow(() -> new LinkRefusedException(closed));
        Fingerprint boat = keys.identity().fingerprint();
        if (!PairingSecret.isEqual(words.proofOfBase(base, boat), proof)) {
            wrong++;
            int left = MOST_WRONG - wrong;
            if (left == 0) {
                close("there were " + MOST_WRONG + " wrong words: begin the pairing anew at the boat");
            }
            throw new LinkRefusedException("the words are not those that the boat shows, or somebody is in between; "
                    + left + (left == 1 ? " try is left" : " tries are left"));
        }
        Peer paired = new Peer(base, name, wished == Role.OBSERVER ? wished : role);
        keys.add(paired);
        close("the words have been used: begin the pairing anew at the boat");
        listener.paired(paired, PairingSecret.checkCode(base, boat));
        return words.proofOfBoat(base, boat);
    }

    private void close(String why) {
        secret = Optional.empty();
        closed = why;
    }
}
