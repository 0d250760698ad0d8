package org.sami.boat.link.security;

import java.util.Objects;
import org.sami.boat.link.Role;

/** A boat or base whose key is known, and what it may do here. Immutable. */
public final class Peer {
    private final Fingerprint fingerprint;
    private final String name;
    private final Role role;

    /**
     * A peer.
     *
     * @param name for people; 1 to 100 printable characters
     * @param role the most that it is granted; a boat's is not looked at
     */
    public Peer(Fingerprint fingerprint, String name, Role role) {
        this.fingerprint = Objects.requireNonNull(fingerprint, "fingerprint");
        this.name = Objects.requireNonNull(name, "name");
        this.role = Objects.requireNonNull(role, "role");
        if (!name.matches("\\P{C}{1,100}")) {
            throw new IllegalArgumentException("the name of a key has 1 to 100 printable characters");
        }
    }

    /** Names its key. */
    public Fingerprint fingerprint() {
        return fingerprint;
    }

    /** Its name, for people. */
    public String name() {
        return name;
    }

    /** The most that it is granted. */
    public Role role() {
        return role;
    }
}
