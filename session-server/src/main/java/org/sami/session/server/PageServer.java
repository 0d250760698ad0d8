package org.sami.session.server;

import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.SecureRandom;
import java.security.cert.Certificate;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.net.ssl.KeyManagerFactory;
import javax.net.ssl.SSLContext;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
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
import org.sami.session.map.TileFile;
import org.sami.session.person.People;

/** The page at {@code /} with its background map, and a WebSocket at {@code /session}, by HTTPS with the key of this base; plain HTTP on loopback only. Jetty's side of a server. */
final class PageServer {
    private static final int MOST_MESSAGE_BYTES = 64 * 1024;
    private static final int MOST_HEADER_BYTES = 8 * 1024;
    private static final Duration IDLE = Duration.ofSeconds(60);
    private static final int MOST_THREADS = 24;
    private static final long STOP_MS = 2000;

    private final ServerAddress address;
    private final People people;
    private final SessionBases bases;
    private final Function<String, Object> sockets;
    private final Server server;
    private final ServerConnector connector;

    /**
     * A server that has not begun.
     *
     * @param bases whose pages may open the WebSocket too
     * @param first answer before the page does: pictures and logs of boats
     * @param sockets what takes a new WebSocket of a client's address, for Jetty
     * @throws IllegalArgumentException if the session would be open to others than this machine without keys
     */
    PageServer(
            ServerAddress address,
            People people,
            SessionBases bases,
            Optional<TileFile> map,
            List<Handler.Wrapper> first,
            Function<String, Object> sockets)
            throws IOException {
        if (!people.needKeys() && !address.host().isLoopbackAddress()) {
            throw new IllegalArgumentException(
                    "without people and keys a session is served on a loopback address only");
        }
        this.address = address;
        this.people = people;
        this.bases = bases;
        this.sockets = sockets;
        QueuedThreadPool threads = new QueuedThreadPool(MOST_THREADS);
        threads.setName("session server");
        threads.setDaemon(true);
        server = new Server(threads);
        connector = connector(server, address);
        server.addConnector(connector);
        WebSocketUpgradeHandler upgrades = WebSocketUpgradeHandler.from(server, this::configure);
        Handler pages = new TileHandler(map, bases, new PageHandler(bases));
        for (Handler.Wrapper one : first) {
            one.setHandler(pages);
            pages = one;
        }
        upgrades.setHandler(pages);
        server.setHandler(upgrades);
    }

    /**
     * Serves from now on.
     *
     * @throws IOException if the address is taken
     */
    void start() throws IOException {
        try {
            server.start();
        } catch (IOException taken) {
            stop();
            throw said(taken);
        } catch (Exception fault) {
            stop();
            throw new IOException("the session cannot be served: " + fault.getMessage(), fault);
        }
    }

    /** The same, in words where another program has the port. */
    private IOException said(IOException fault) {
        boolean taken = fault.getCause() instanceof BindException bind
                && String.valueOf(bind.getMessage()).startsWith("Address already in use");
        return taken
                ? new IOException(
                        "port " + address.port() + " is taken by another program, such as another session;"
                                + " --port gives another one",
                        fault)
                : fault;
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
                return sockets.apply(Request.getRemoteAddr(request));
            }
            Response.writeError(
                    request, response, callback, HttpStatus.FORBIDDEN_403, "not from the session's own page");
            return null;
        });
    }

    /**
     * Whether no page of elsewhere opens the link, but those of the session's other bases: it would act with the person's address. Where no key is needed, the name of the host must be this
     * machine's own too, as a name of elsewhere can be made to lead here.
     */
    private boolean isOfOwnPage(ServerUpgradeRequest request) {
        String host =
                Optional.ofNullable(request.getHeaders().get(HttpHeader.HOST)).orElse("");
        Optional<String> origin = Optional.ofNullable(request.getHeaders().get(HttpHeader.ORIGIN));
        String scheme = address.identity().isPresent() ? "https://" : "http://";
        boolean own = people.needKeys() || host.matches("(localhost|127\\.[0-9.]+|\\[::1\\])(:[0-9]+)?");
        return own
                && origin.map(page -> (scheme + host).equalsIgnoreCase(page) || bases.haveOrigin(page))
                        .orElse(true);
    }

    /** Where it listens. */
    InetSocketAddress listensAt() {
        return new InetSocketAddress(address.host(), connector.getLocalPort());
    }

    /** Its address for browsers, such as {@code https://10.0.0.5:8443/}. */
    String url() {
        String host = address.host().getHostAddress();
        return (address.identity().isPresent() ? "https://" : "http://")
                + (host.contains(":") ? "[" + host + "]" : host) + ":" + connector.getLocalPort() + "/";
    }

    /** The SHA-256 of the certificate, as browsers show it; empty for plain HTTP. */
    Optional<String> certificate() {
        return address.identity().map(ServerAddress::print);
    }

    void stop() {
        try {
            server.setStopTimeout(STOP_MS);
            server.stop();
        } catch (Exception alreadyGone) {
            server.destroy();
        }
    }
}
