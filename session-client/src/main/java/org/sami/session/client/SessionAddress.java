package org.sami.session.client;

import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;

/**
 * Where a session is served: {@code wss://HOST:PORT}, or {@code ws://HOST:PORT} on this machine. Immutable.
 *
 * @param secure by TLS
 */
public record SessionAddress(boolean secure, String host, int port) {
    private static final int HIGHEST_PORT = 65_535;

    /**
     * Reads an address. It has no name and no key in it: those would be seen in the list of processes.
     *
     * @throws IllegalArgumentException in words, if it is none, or would send a key in plain text to another machine
     */
    public static SessionAddress parse(String text) {
        URI uri;
        try {
            uri = new URI(text);
        } catch (URISyntaxException malformed) {
            throw noAddress();
        }
        boolean secure = "wss".equals(uri.getScheme());
        boolean rest = uri.getUserInfo() != null || uri.getQuery() != null || uri.getFragment() != null;
        String path = uri.getPath() == null ? "" : uri.getPath();
        if (!(secure || "ws".equals(uri.getScheme()))
                || uri.getHost() == null
                || uri.getPort() < 1
                || uri.getPort() > HIGHEST_PORT
                || rest
                || !(path.isEmpty() || path.equals("/"))) {
            throw noAddress();
        }
        if (!secure && !isHere(uri.getHost())) {
            throw new IllegalArgumentException(
                    "keys are sent by TLS only: wss://" + uri.getHost() + ":" + uri.getPort());
        }
        return new SessionAddress(secure, uri.getHost(), uri.getPort());
    }

    private static IllegalArgumentException noAddress() {
        return new IllegalArgumentException(
                "a session's address is wss://HOST:PORT, or ws://HOST:PORT on this machine, without a name or key");
    }

    private static boolean isHere(String host) {
        try {
            return InetAddress.getByName(host).isLoopbackAddress();
        } catch (UnknownHostException elsewhere) {
            return false;
        }
    }

    /** The address of its link. */
    URI link() {
        return URI.create((secure ? "wss://" : "ws://") + authority() + "/session");
    }

    /** The address of something that its server gives over HTTP. */
    URI page(String path) {
        return URI.create((secure ? "https://" : "http://") + authority() + "/" + path);
    }

    /** Host and port. */
    String authority() {
        return host + ":" + port;
    }

    @Override
    public String toString() {
        return (secure ? "wss://" : "ws://") + authority();
    }
}
