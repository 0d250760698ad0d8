package org.sami.session.server;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.session.Session;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.map.TileFile;
import org.sami.session.person.People;

/**
 * Serves a session to several people: the page at {@code /}, the link of docs/session-link.md at {@code /session}. HTTPS with the key of this base;
 * plain HTTP on loopback only. It may be started before the session begins, and is closed before the session.
 */
public final class SessionServer implements AutoCloseable {
    private final Fronts fronts;
    private final PictureHandler pictures;
    private final LogHandler logs;
    private final PageServer server;

    private SessionServer(
            Session session, People people, ServerAddress address, Optional<TileFile> map, SessionBases bases)
            throws IOException {
        Tickets tickets = new Tickets();
        fronts = new Fronts(
                session,
                people,
                HandlerModules.robotsOf(session.setup().vocabulary()),
                bases,
                tickets,
                System::nanoTime);
        ThreadGuard guard = session.faults().guard();
        pictures = new PictureHandler(session.models().pictures()::snapshot, tickets::person, bases, guard);
        logs = new LogHandler(
                LogBoats.of(session.fleet()),
                tickets::person,
                bases,
                new LogNews(fronts.news(), System::nanoTime),
                System::nanoTime,
                guard);
        server = new PageServer(address, people, bases, map, List.of(pictures, logs), fronts::connect);
    }

    /**
     * Serves a session from now on.
     *
     * @throws IOException if the address is taken
     * @throws IllegalArgumentException if the session would be open to others than this machine without keys
     */
    public static SessionServer start(Session session, People people, ServerAddress address) throws IOException {
        return start(session, people, address, Optional.empty(), SessionBases.NONE);
    }

    /**
     * Serves a session over a background map, which its caller closes after the server.
     *
     * @param bases all bases of the session, of which fronts are told
     * @throws IOException if the address is taken
     * @throws IllegalArgumentException if the session would be open to others than this machine without keys
     */
    public static SessionServer start(
            Session session, People people, ServerAddress address, Optional<TileFile> map, SessionBases bases)
            throws IOException {
        SessionServer one = new SessionServer(session, people, address, map, bases);
        one.server.start();
        try {
            one.fronts.start();
        } catch (IOException unreadable) {
            one.close();
            throw unreadable;
        }
        return one;
    }

    /** Where it listens. */
    public InetSocketAddress listensAt() {
        return server.listensAt();
    }

    /** Its address for browsers, such as {@code https://10.0.0.5:8443/}. */
    public String url() {
        return server.url();
    }

    /** The SHA-256 of the certificate, as browsers show it; empty for plain HTTP. */
    public Optional<String> certificate() {
        return server.certificate();
    }

    @Override
    public void close() {
        fronts.close();
        pictures.close();
        logs.close();
        server.stop();
    }
}
