package org.sami.session.server;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;

/** Serves the files of the page from the classpath, with headers that keep a browser to them. */
final class PageHandler extends Handler.Abstract {
    /** Where the page's files are on the classpath. */
    static final String FOLDER = "org/sami/session/page";

    /** Where the map library is on the classpath; the page has it below {@code /leaflet/}. */
    private static final String LEAFLET = "META-INF/resources/webjars/leaflet/1.9.4/dist";

    private static final String LEAFLET_PATH = "/leaflet/";

    private static final String POLICY =
            "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:%s;"
                    + " font-src 'self'; connect-src 'self'%s; manifest-src 'self'; worker-src 'self'; base-uri 'none';"
                    + " form-action 'none'; frame-ancestors 'none'";
    private static final int MOST_BYTES = 8 << 20;
    private static final Pattern PATH = Pattern.compile("(/[A-Za-z0-9_-][A-Za-z0-9_.-]*)+");
    private static final String TEXT = "text/plain; charset=utf-8";
    private static final Map<String, String> TYPES = Map.ofEntries(
            Map.entry("html", "text/html; charset=utf-8"),
            Map.entry("js", "text/javascript; charset=utf-8"),
            Map.entry("css", "text/css; charset=utf-8"),
            Map.entry("json", "application/json"),
            Map.entry("map", "application/json"),
            Map.entry("webmanifest", "application/manifest+json"),
            Map.entry("svg", "image/svg+xml"),
            Map.entry("png", "image/png"),
            Map.entry("ico", "image/x-icon"),
            Map.entry("woff2", "font/woff2"),
            Map.entry("txt", TEXT),
            Map.entry("pbf", "application/x-protobuf"));

    private final String policy;

    /**
     * Serves the page.
     *
     * @param bases to which the page may connect besides, and whose map it may show
     */
    PageHandler(SessionBases bases) {
        policy = POLICY.formatted(bases.origins(), bases.sources());
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws IOException {
        response.getHeaders()
                .put("Content-Security-Policy", policy)
                .put("X-Content-Type-Options", "nosniff")
                .put("Referrer-Policy", "no-referrer")
                .put("Cross-Origin-Opener-Policy", "same-origin")
                .put("Cross-Origin-Resource-Policy", "same-origin")
                .put(HttpHeader.CACHE_CONTROL, "no-cache");
        String method = request.getMethod();
        if (!HttpMethod.GET.is(method) && !HttpMethod.HEAD.is(method)) {
            send(response, HttpStatus.METHOD_NOT_ALLOWED_405, TEXT, bytes("GET only\n"), callback);
            return true;
        }
        String path = Request.getPathInContext(request);
        String file = path.equals("/") ? "/index.html" : path;
        Optional<byte[]> content = PATH.matcher(file).matches() ? content(file) : Optional.empty();
        if (content.isPresent()) {
            String type = TYPES.getOrDefault(file.substring(file.lastIndexOf('.') + 1), "application/octet-stream");
            send(response, HttpStatus.OK_200, type, content.get(), callback);
        } else {
            send(response, HttpStatus.NOT_FOUND_404, TEXT, bytes("Nothing is here\n"), callback);
        }
        return true;
    }

    private static Optional<byte[]> content(String file) throws IOException {
        String place =
                file.startsWith(LEAFLET_PATH) ? LEAFLET + file.substring(LEAFLET_PATH.length() - 1) : FOLDER + file;
        try (InputStream in = PageHandler.class.getClassLoader().getResourceAsStream(place)) {
            if (in == null) {
                return Optional.empty();
            }
            byte[] content = in.readNBytes(MOST_BYTES + 1);
            return content.length > MOST_BYTES ? Optional.empty() : Optional.of(content);
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static void send(Response response, int status, String type, byte[] content, Callback callback) {
        response.setStatus(status);
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, type).put(HttpHeader.CONTENT_LENGTH, content.length);
        response.write(true, ByteBuffer.wrap(content), callback);
    }
}
