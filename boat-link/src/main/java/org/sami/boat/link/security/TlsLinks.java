package org.sami.boat.link.security;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.security.GeneralSecurityException;
import java.security.cert.Certificate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.net.ssl.KeyManager;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;

/**
 * Links over TLS 1.3, or 1.2 where one side has no 1.3. Both sides show their certificates, and each knows the key of the other afterwards. A base goes on only
 * with a boat whose key is pinned. A boat accepts any key, and its owner decides what that may do: an unknown one only learns who the boat is.
 */
public final class TlsLinks implements LinkSecurity {
    private static final List<String> VERSIONS = Arrays.asList("TLSv1.3", "TLSv1.2");

    private final SSLContext context;
    private final Predicate<Fingerprint> pinned;
    private final List<String> versions;
    private final Supplier<List<Fingerprint>> withdrawn;

    /**
     * Links with an own key.
     *
     * @param pinned whether a boat has a key that this base knows; not asked on the boat's side
     */
    public TlsLinks(Identity identity, Predicate<Fingerprint> pinned) {
        this(identity, pinned, VERSIONS, Collections::emptyList);
    }

    /** Links that speak only some versions, as on a phone without the newest. */
    TlsLinks(Identity identity, Predicate<Fingerprint> pinned, List<String> versions) {
        this(identity, pinned, versions, Collections::emptyList);
    }

    private TlsLinks(
            Identity identity,
            Predicate<Fingerprint> pinned,
            List<String> versions,
            Supplier<List<Fingerprint>> withdrawn) {
        this.withdrawn = withdrawn;
        this.pinned = pinned;
        this.versions = versions;
        try {
            context = SSLContext.getInstance("TLS");
            context.init(
                    new KeyManager[] {new OwnKeyManager(identity)},
                    new TrustManager[] {new AnyKeyTrustManager()},
                    null);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java and every Android has TLS", e);
        }
    }

    /** Links of the keys in a ring: a base goes on with the boats that are paired. */
    public static TlsLinks of(KeyRing keys) {
        return new TlsLinks(keys.identity(), key -> keys.find(key).isPresent(), VERSIONS, keys::withdrawn);
    }

    /** Links to boats that are not paired yet, in order to pair them: any key is taken. */
    public static TlsLinks toPair(Identity identity) {
        return new TlsLinks(identity, key -> true);
    }

    @Override
    public SecureLink accept(Socket socket) throws IOException {
        return handshake(socket, false);
    }

    @Override
    public SecureLink connect(Socket socket) throws IOException {
        InetSocketAddress address = (InetSocketAddress) socket.getRemoteSocketAddress();
        SecureLink link = handshake(socket, true);
        Fingerprint peer = link.peer().orElseThrow(() -> new LinkRefusedException("it shows no key"));
        if (!pinned.test(peer)) {
            throw new LinkRefusedException("its key " + peer.shortText()
                    + " is not paired with this base: crw keys pair " + address.getHostString() + ":"
                    + address.getPort());
        }
        return link;
    }

    @Override
    public List<Fingerprint> withdrawn() {
        return withdrawn.get();
    }

    private SSLSocket layered(Socket socket) throws IOException {
        InetSocketAddress address = (InetSocketAddress) socket.getRemoteSocketAddress();
        return (SSLSocket) context.getSocketFactory()
                .createSocket(socket, address.getAddress().getHostAddress(), address.getPort(), true);
    }

    /** Whatever fails here is a refusal, also a socket that was closed before the first byte. */
    private SecureLink handshake(Socket socket, boolean isBase) throws IOException {
        try {
            SSLSocket secured = layered(socket);
            secured.setUseClientMode(isBase);
            if (!isBase) {
                secured.setNeedClientAuth(true);
            }
            List<String> spoken = new ArrayList<>(versions);
            spoken.retainAll(Arrays.asList(secured.getSupportedProtocols()));
            secured.setEnabledProtocols(spoken.toArray(new String[0]));
            secured.startHandshake();
            Certificate[] chain = secured.getSession().getPeerCertificates();
            return new EstablishedLink(secured, Fingerprint.of(chain[0].getPublicKey()));
        } catch (IOException e) {
            boolean plain = String.valueOf(e.getMessage()).contains("unrecognized SSL message");
            String why = plain ? "it speaks plain, and only protected links are taken here" : words(e);
            throw new LinkRefusedException("no protected link: " + why, e);
        }
    }

    private static String words(IOException e) {
        return e.getMessage() == null ? e.toString() : e.getMessage();
    }

    /** The version of the protocol that a link speaks. */
    static String version(SecureLink link) {
        return ((EstablishedLink) link).socket.getSession().getProtocol();
    }

    private static final class EstablishedLink implements SecureLink {
        private final SSLSocket socket;
        private final Fingerprint peer;

        EstablishedLink(SSLSocket socket, Fingerprint peer) {
            this.socket = socket;
            this.peer = peer;
        }

        @Override
        public InputStream in() throws IOException {
            return socket.getInputStream();
        }

        @Override
        public OutputStream out() throws IOException {
            return socket.getOutputStream();
        }

        @Override
        public Optional<Fingerprint> peer() {
            return Optional.of(peer);
        }
    }
}
