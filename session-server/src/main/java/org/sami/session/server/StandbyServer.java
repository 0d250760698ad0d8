package org.sami.session.server;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.session.map.TileFile;
import org.sami.session.person.People;

/**
 * Answers for a base that waits for another's session: the page at {@code /}, and at {@code /session} who holds the session, and where the other bases are (docs/session-link.md, Bases). Takes
 * no name and no key. It is closed before the session is served at the same address. Safe for use by several threads.
 */
public final class StandbyServer implements AutoCloseable {
    private final SessionBases bases;
    private final PageServer server;
    private volatile String waitsFor = "it has not found the session yet";

    private StandbyServer(People people, ServerAddress address, Optional<TileFile> map, SessionBases bases)
            throws IOException {
        this.bases = bases;
        server = new PageServer(
                address, people, bases, map, List.of(new StandbyLogHandler()), from -> new StandbyFront(message()));
    }

    /**
     * Answers from now on.
     *
     * @param people those of the session: without keys it is for this machine only
     * @param map for the page; closed by its caller after this
     * @throws IOException if the address is taken
     * @throws IllegalArgumentException if the session would be open to others than this machine without keys
     */
    public static StandbyServer start(People people, ServerAddress address, Optional<TileFile> map, SessionBases bases)
            throws IOException {
        StandbyServer one = new StandbyServer(people, address, map, bases);
        one.server.start();
        return one;
    }

    /** Says from now on what it waits for, such as who holds the session. */
    public void say(String line) {
        waitsFor = line;
    }

    private String message() {
        return JsonNodeFactory.instance
                .objectNode()
                .put("t", "standby")
                .put("text", waitsFor)
                .set("bases", bases.list())
                .toString();
    }

    /** Where it listens. */
    public InetSocketAddress listensAt() {
        return server.listensAt();
    }

    /** Its address for browsers, such as {@code https://10.0.0.6:8443/}. */
    public String url() {
        return server.url();
    }

    /** The SHA-256 of the certificate, as browsers show it; empty for plain HTTP. */
    public Optional<String> certificate() {
        return server.certificate();
    }

    @Override
    public void close() {
        server.stop();
    }
}
