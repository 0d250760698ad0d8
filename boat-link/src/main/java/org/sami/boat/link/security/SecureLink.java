package org.sami.boat.link.security;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Optional;

/** The streams of one connection, and whose key is at its other end. */
public interface SecureLink {
    /** What the peer sends. */
    InputStream in() throws IOException;

    /** What goes to the peer. */
    OutputStream out() throws IOException;

    /** The peer's key; empty on a link without protection. */
    Optional<Fingerprint> peer();
}
