package org.sami.session.server;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.security.cert.Certificate;
import java.time.Duration;
import java.util.HexFormat;
import java.util.Optional;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.server.SecureRequestCustomizer;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.ssl.SslContextFactory;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.eclipse.jetty.websocket.server.ServerUpgradeRequest;
import org.eclipse.jetty.websocket.server.ServerWebSocketContainer;
import org.eclipse.jetty.websocket.server.WebSocketUpgradeHandler;
import org.sami.boat.link.security.Identity;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.session.Session;
import org.sami.session.map.TileFile;
import org.sami.session.person.People;

/**
 * Serves a session to several people: the page at {@code /}, the link of docs/session-link.md at {@code /session}. HTTPS with the key of this base;
 * plain HTTP on loopback only. It may be started before the session begins, and is closed before the session.
 */
public final class SessionServer implements AutoCloseable {
    private static final int MOST_MESSAGE_BYTES = 64 * 1024;
    private static final int MOST_HEADER_BYTES = 8 * 1024;
    private static final Duration IDLE = Duration.ofSeconds(60);
    private static final int MOST_THREADS = 24;
    private static final long STOP_MS = 2000;

    private final ServerAddress address;
    private final People people;
    private final Fronts fronts;
    private final PictureHandler pictures;
    private final Server server;
    private final ServerConnector connector;

    private SessionServer(Session session, People people, ServerAddress address, Optional<TileFile> map)
            throws IOException {
        if (!people.needKeys() && !address.host().isLoopbackAddress()) {
            throw new IllegalArgumentException(
                    "without people and keys a session is served on a loopback address only");
        }
        this.address = address;
        this.people = people;
        Tickets tickets = new Tickets();
        fronts = new Fronts(
                session, people, HandlerModules.robotsOf(session.setup().vocabulary()), tickets, System::nanoTime);
        pictures = new PictureHandler(
                session.models().pictures()::snapshot, tickets, new TileHandler(map, new PageHandler()));
        QueuedThreadPool threads = new QueuedThreadPool(MOST_THREADS);
        threads.setName("session server");
        threads.setDaemon(true);
        server = new Server(threads);
        connector = connector(server, address);
        server.addConnector(connector);
        WebSocketUpgradeHandler sockets = WebSocketUpgradeHandler.from(server, this::configure);
        sockets.setHandler(pictures);
        server.setHandler(sockets);
    }

    /**
     * Serves a session from now on.
     *
     * @throws IOException if the address is taken
     * @throws IllegalArgumentException if the session would be open to others than this machine without keys
     */
    public static SessionServer start(Session session, People people, ServerAddress address) throws IOException {
        return start(session, people, address, Optional.empty());
    }

    /**
     * Serves a session over a background map, which its caller closes after the server.
     *
     * @throws IOException if the address is taken
     * @throws IllegalArgumentException if the session would be open to others than this machine without keys
     */
    public static SessionServer start(Session session, People people, ServerAddress address, Optional<TileFile> map)
            throws IOException {
        SessionServer one = new SessionServer(session, people, address, map);
        try {
            one.server.start();
        } catch (IOException taken) {
            one.stopServer();
            throw taken;
        } catch (Exception fault) {
            one.stopServer();
            throw new IOException("the session cannot be served: " + fault.getMessage(), fault);
        }
        try {
            one.fronts.start();
        } catch (IOException unreadable) {
            one.close();
            throw unreadable;
        }
        return one;
    }

    private static ServerConnector connector(Server server, ServerAddress address) throws IOException {
        HttpConfiguration http = new HttpConfiguration();
        http.setSendServerVersion(false);
        http.setRequestHeaderSize(MOST_HEADER_BYTES);
        HttpConnectionFactory plain = new HttpConnectionFactory(http);
        Optional<Identity> identity = address.identity();
        ServerConnector connector;
        if (identity.isPresent()) {
            http.addCustomizer(new SecureRequestCustomizer(false)); // the certificate carries a key and no name
            SslContextFactory.Server tls = new SslContextFactory.Server();
            tls.setSslContext(context(identity.get()));
            tls.setIncludeProtocols("TLSv1.3", "TLSv1.2");
            connector = new ServerConnector(server, tls, plain);
        } else {
            connector = new ServerConnector(server, plain);
        }
        connector.setHost(address.host().getHostAddress());
        connector.setPort(address.port());
        connector.setIdleTimeout(IDLE.toMillis());
        return connector;
    }

    private static SSLContext context(Identity identity) throws IOException {
        try {
            char[] none = new char[0];
            KeyStore store = KeyStore.getInstance("PKCS12");
            store.load(null, none);
            store.setKeyEntry("base", identity.key(), none, new Certificate[] {identity.certificate()});
            KeyManagerFactory keys = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm());
            keys.init(store, none);
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(keys.getKeyManagers(), null, new SecureRandom());
            return context;
        } catch (GeneralSecurityException e) {
            throw new IOException("the key of this base cannot be used for HTTPS: " + e.getMessage(), e);
        }
    }

    private void configure(ServerWebSocketContainer container) {
        container.setMaxTextMessageSize(MOST_MESSAGE_BYTES);
        container.setMaxBinaryMessageSize(1);
        container.setMaxFrameSize(MOST_MESSAGE_BYTES);
        container.setIdleTimeout(IDLE);
        container.addMapping("/session", (request, response, callback) -> {
            if (isOfOwnPage(request)) {
                return fronts.connect(Request.getRemoteAddr(request));
            }
            Response.writeError(
                    request, response, callback, HttpStatus.FORBIDDEN_403, "not from the session's own page");
            return null;
        });
    }

    /**
     * Whether no page of elsewhere opens the link: it would act with the person's address. Where no key is needed, the name of the host must be this
     * machine's own too, as a name of elsewhere can be made to lead here.
     */
    private boolean isOfOwnPage(ServerUpgradeRequest request) {
        String host =
                Optional.ofNullable(request.getHeaders().get(HttpHeader.HOST)).orElse("");
        Optional<String> origin = Optional.ofNullable(request.getHeaders().get(HttpHeader.ORIGIN));
        String scheme = address.identity().isPresent() ? "https://" : "http://";
        boolean own = people.needKeys() || host.matches("(localhost|127\\.[0-9.]+|\\[::1\\])(:[0-9]+)?");
        return own && origin.map((scheme + host)::equalsIgnoreCase).orElse(true);
    }

    /** Where it listens. */
    public InetSocketAddress listensAt() {
        return new InetSocketAddress(address.host(), connector.getLocalPort());
    }

    /** Its address for browsers, such as {@code https://10.0.0.5:8443/}. */
    public String url() {
        String host = address.host().getHostAddress();
        return (address.identity().isPresent() ? "https://" : "http://")
                + (host.contains(":") ? "[" + host + "]" : host) + ":" + connector.getLocalPort() + "/";
    }

    /** The SHA-256 of the certificate, as browsers show it; empty for plain HTTP. */
    public Optional<String> certificate() {
        return address.identity().map(identity -> {
            try {
                byte[] hash = MessageDigest.getInstance("SHA-256")
                        .digest(identity.certificate().getEncoded());
                return HexFormat.ofDelimiter(":").withUpperCase().formatHex(hash);
            } catch (GeneralSecurityException e) {
                throw new IllegalStateException("a certificate in use can be written", e);
            }
        });
    }

    @Override
    public void close() {
        fronts.close();
        pictures.close();
        stopServer();
    }

    private void stopServer() {
        try {
            server.setStopTimeout(STOP_MS);
            server.stop();
        } catch (Exception alreadyGone) {
            server.destroy();
        }
    }
}
