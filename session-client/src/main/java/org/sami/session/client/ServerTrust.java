package org.sami.session.client;

import java.io.IOException;
import java.net.Socket;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.cert.CertificateException;
import java.security.cert.X509Certificate;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiPredicate;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.TrustManager;
import javax.net.ssl.X509ExtendedTrustManager;

/**
 * Trusts a session's server by its certificate, which carries a key and no name (decision 0473): the one that was compared at the first connection, and no other
 * afterwards; other bases of a session by what a trusted one names. Safe for use by several threads.
 */
public final class ServerTrust {
    private final KnownServers known;
    private final BiPredicate<String, String> confirm;
    private final Map<String, String> announced = new ConcurrentHashMap<>(); // by HOST:PORT
    private volatile boolean asks = true;

    /**
     * Trust in servers that are known, or that somebody confirms.
     *
     * @param confirm given {@code HOST:PORT} and the SHA-256 of a certificate that nobody has compared yet, as {@code crw serve} prints it: whether it is that one; may wait
     */
    public ServerTrust(KnownServers known, BiPredicate<String, String> confirm) {
        this.known = known;
        this.confirm = confirm;
    }

    /**
     * A base that is trusted names the certificate of another base of its session. It is trusted for this session alone and not kept: whoever connects there first by hand compares it as any
     * other. What a person has compared goes before it.
     */
    void announce(String authority, String print) {
        announced.put(authority, print);
    }

    /** From now on no person is asked to compare a certificate: people work in the session. */
    void askNoLonger() {
        asks = false;
    }

    SSLContext context(SessionAddress address) {
        try {
            SSLContext context = SSLContext.getInstance("TLS");
            context.init(null, new TrustManager[] {new OfOneServer(address.authority())}, null);
            return context;
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("every Java has TLS", e);
        }
    }

    private void check(String authority, X509Certificate certificate) throws CertificateException {
        try {
            String print = HexFormat.ofDelimiter(":")
                    .withUpperCase()
                    .formatHex(MessageDigest.getInstance("SHA-256").digest(certificate.getEncoded()));
            Optional<String> before = known.certificate(authority);
            if (before.isPresent() && !before.get().equals(print)) {
                throw new CertificateException(
                        "another server is at " + authority + ", or it has a new key: its certificate has the SHA-256 "
                                + print + "; if that is right, take its line out of " + known.file());
            }
            if (before.isEmpty()) {
                checkNew(authority, print);
            }
        } catch (IOException | GeneralSecurityException fault) {
            throw fault instanceof CertificateException refused ? refused : new CertificateException(fault);
        }
    }

    private void checkNew(String authority, String print) throws IOException, CertificateException {
        String named = announced.get(authority);
        if (print.equals(named)) {
            return;
        }
        if (named != null) {
            throw new CertificateException("another server is at " + authority
                    + " than the session's base: its certificate has the SHA-256 " + print);
        }
        if (!asks || !confirm.test(authority, print)) {
            throw new CertificateException(
                    "nobody has compared the certificate of " + authority + ", whose SHA-256 is " + print);
        }
        known.add(authority, print);
    }

    private final class OfOneServer extends X509ExtendedTrustManager {
        private final String authority;

        OfOneServer(String authority) {
            this.authority = authority;
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String authType) throws CertificateException {
            check(authority, chain[0]);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String authType, Socket socket)
                throws CertificateException {
            check(authority, chain[0]);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String authType, SSLEngine engine)
                throws CertificateException {
            check(authority, chain[0]);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String authType) throws CertificateException {
            throw new CertificateException("this is no server");
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String authType, Socket socket)
                throws CertificateException {
            throw new CertificateException("this is no server");
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String authType, SSLEngine engine)
                throws CertificateException {
            throw new CertificateException("this is no server");
        }

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return new X509Certificate[0];
        }
    }
}
