package org.sami.boat.link.security;

import java.io.IOException;
import java.net.Socket;
import java.util.Collections;
import java.util.List;

/** How the connections of a boat or base are protected. Safe for use by several threads. */
public interface LinkSecurity {
    /**
     * Protects a socket that was accepted, and waits for the peer's part in that as long as the socket's read timeout allows.
     *
     * @throws LinkRefusedException with the reason, if the peer does not do its part
     */
    SecureLink accept(Socket socket) throws IOException;

    /**
     * Protects a socket that is connected.
     *
     * @throws LinkRefusedException with the reason, if the peer does not do its part or is not paired
     */
    SecureLink connect(Socket socket) throws IOException;

    /** Keys that were withdrawn here, which a base carries to the boats that it commands. */
    default List<Fingerprint> withdrawn() {
        return Collections.emptyList();
    }
}
