package org.sami.session.server;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.sami.session.rows.Table;

/**
 * The bases that hold a session one after the other, as fronts reach them: one holds it, the others are its standbys. Fronts that lose one go to the next (docs/decisions 0575). Immutable.
 */
public record SessionBases(List<Base> all) {
    /** A session that one base holds alone. */
    public static final SessionBases NONE = new SessionBases(List.of());

    private static final int HIGHEST_PORT = 65_535;
    private static final String PRINT = "([0-9A-F]{2}:){31}[0-9A-F]{2}";
    private static final int MOST = 20;

    /**
     * One base.
     *
     * @param address {@code wss://HOST:PORT}, or {@code ws://HOST:PORT} on this machine
     * @param certificate the SHA-256 of its certificate; empty for {@code ws}
     */
    public record Base(String address, Optional<String> certificate) {
        private ObjectNode row() {
            ObjectNode row = JsonNodeFactory.instance.objectNode().put("id", address);
            certificate.ifPresent(print -> row.put("certificate", print));
            return row;
        }

        private String origin() {
            return "http" + address.substring("ws".length());
        }
    }

    public SessionBases {
        all = List.copyOf(all);
    }

    /**
     * Reads the addresses of bases, each with the SHA-256 of its certificate: {@code wss://HOST:PORT=SHA-256}.
     *
     * @throws IllegalArgumentException in words, if one is none, or lacks its certificate
     */
    public static SessionBases parse(List<String> texts) {
        List<Base> all = new ArrayList<>();
        for (String text : texts) {
            int end = text.indexOf('=');
            String address = address(end < 0 ? text : text.substring(0, end));
            boolean secure = address.startsWith("wss:");
            Optional<String> print = end < 0
                    ? Optional.empty()
                    : Optional.of(text.substring(end + 1).toUpperCase(Locale.ROOT));
            if (secure && print.filter(one -> one.matches(PRINT)).isEmpty()) {
                throw new IllegalArgumentException(address
                        + " needs the SHA-256 of that base's certificate, as it prints it: " + address + "=AB:CD:...");
            }
            all.add(new Base(address, secure ? print : Optional.empty()));
        }
        if (all.size() > MOST) {
            throw new IllegalArgumentException("a session has at most " + MOST + " bases, not " + all.size());
        }
        return new SessionBases(all);
    }

    private static String address(String text) {
        try {
            URI uri = new URI(text);
            String path = Optional.ofNullable(uri.getPath()).orElse("");
            boolean rest = uri.getUserInfo() != null || uri.getQuery() != null || uri.getFragment() != null;
            boolean port = uri.getPort() >= 1 && uri.getPort() <= HIGHEST_PORT;
            boolean place = uri.getHost() != null && port && !rest && (path.isEmpty() || path.equals("/"));
            if (place && ("wss".equals(uri.getScheme()) || ("ws".equals(uri.getScheme()) && isHere(uri.getHost())))) {
                return uri.getScheme() + "://" + uri.getHost() + ":" + uri.getPort();
            }
        } catch (URISyntaxException malformed) {
            // refused below
        }
        throw new IllegalArgumentException(
                "a base's address is wss://HOST:PORT=SHA-256, or ws://HOST:PORT on this machine, not '" + text + "'");
    }

    private static boolean isHere(String host) {
        try {
            return InetAddress.getByName(host).isLoopbackAddress();
        } catch (UnknownHostException elsewhere) {
            return false;
        }
    }

    /** The rows of the bases, for fronts. */
    Table table() {
        Map<String, ObjectNode> rows = new LinkedHashMap<>();
        all.forEach(base -> rows.put(base.address(), base.row()));
        return new Table("bases", rows);
    }

    /** The same rows, for a message without tables. */
    ArrayNode list() {
        ArrayNode list = JsonNodeFactory.instance.arrayNode();
        all.forEach(base -> list.add(base.row()));
        return list;
    }

    /** Whether a page of one of them has this origin, such as {@code https://10.0.0.5:8443}. */
    boolean haveOrigin(String origin) {
        return all.stream().anyMatch(base -> base.origin().equalsIgnoreCase(origin));
    }

    /** The addresses of their links and of what they give over HTTP, with a space before each, for the content policy of the page. */
    String sources() {
        return all.stream().map(base -> " " + base.address()).collect(Collectors.joining()) + origins();
    }

    /** The addresses of what they give over HTTP, with a space before each, for the content policy of the page. */
    String origins() {
        return all.stream().map(base -> " " + base.origin()).collect(Collectors.joining());
    }

    /** Lets a page of one of these bases read a response, where such a page asks; no other page of elsewhere. */
    void letPagesRead(Request request, Response response) {
        Optional.ofNullable(request.getHeaders().get(HttpHeader.ORIGIN))
                .filter(this::haveOrigin)
                .ifPresent(page -> response.getHeaders()
                        .put(HttpHeader.ACCESS_CONTROL_ALLOW_ORIGIN, page)
                        .put(HttpHeader.VARY, "Origin"));
    }
}
