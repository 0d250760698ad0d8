package org.sami.session.client;

import java.util.Objects;

/**
 * Who takes part in a session.
 *
 * @param key as {@code crw people add} printed it; empty text where the session needs none
 */
public record Login(String name, String key) {
    public Login {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(key, "key");
    }

    /** Without the key, which is in no text. */
    @Override
    public String toString() {
        return name;
    }
}
