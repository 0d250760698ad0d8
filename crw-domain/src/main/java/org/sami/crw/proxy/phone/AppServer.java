package org.sami.crw.proxy.phone;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * Serves the app and one page over HTTP, at one address of this computer, below a random path. It serves nothing else, and nothing after it is
 * closed. The pairing code is not in what it serves: it stands behind the {@code #} of the address, which browsers do not send.
 */
final class AppServer implements Closeable {
    static final String APK_NAME = "sami-boat.apk";

    private static final int BACKLOG = 8;
    private static final int THREADS = 4;
    private static final int TOKEN_BYTES = 12;

    private final HttpServer server;
    private final ExecutorService threads;
    private final String path;
    private final Optional<ApkFile> apk;
    private final byte[] page;

    /**
     * Serves from now on.
     *
     * @param apk empty where there is no app: the page says so
     * @throws IOException if nothing can listen at the address
     */
    AppServer(InetAddress address, Optional<ApkFile> apk) throws IOException {
        this.apk = apk;
        byte[] token = new byte[TOKEN_BYTES];
        new SecureRandom().nextBytes(token);
        path = "/" + Base64.getUrlEncoder().withoutPadding().encodeToString(token) + "/";
        server = HttpServer.create(new InetSocketAddress(address, 0), BACKLOG);
        page = AppPage.of(apk, url()).getBytes(StandardCharsets.UTF_8);
        threads = Executors.newFixedThreadPool(THREADS, work -> {
            Thread thread = new Thread(work, "app-server");
            thread.setDaemon(true);
            return thread;
        });
        server.setExecutor(threads);
        server.createContext("/", this::answer);
        server.start();
    }

    /** The address of the page. */
    String url() {
        InetSocketAddress at = server.getAddress();
        return "http://" + new BoatAddress(at.getAddress().getHostAddress(), at.getPort()) + path;
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            String asked = exchange.getRequestURI().getPath();
            boolean head = exchange.getRequestMethod().equals("HEAD");
            if (!head && !exchange.getRequestMethod().equals("GET")) {
                exchange.getResponseHeaders().set("Allow", "GET, HEAD");
                exchange.sendResponseHeaders(405, -1);
            } else if (path.equals(asked)) {
                sendPage(exchange, head);
            } else if ((path + APK_NAME).equals(asked) && apk.isPresent()) {
                sendApk(exchange, apk.get(), head);
            } else {
                exchange.sendResponseHeaders(404, -1);
            }
        }
    }

    private void sendPage(HttpExchange exchange, boolean head) throws IOException {
        Headers headers = headers(exchange, "text/html; charset=utf-8");
        headers.set("Content-Security-Policy", AppPage.POLICY);
        headers.set("Referrer-Policy", "no-referrer");
        if (begin(exchange, page.length, head)) {
            exchange.getResponseBody().write(page);
        }
    }

    private static void sendApk(HttpExchange exchange, ApkFile apk, boolean head) throws IOException {
        ApkFile now = ApkFile.read(apk.path()); // it may have been built again, or replaced by something else
        headers(exchange, "application/vnd.android.package-archive")
                .set("Content-Disposition", "attachment; filename=\"" + APK_NAME + "\"");
        if (begin(exchange, now.bytes(), head)) {
            OutputStream body = exchange.getResponseBody();
            Files.copy(now.path(), body);
        }
    }

    private static Headers headers(HttpExchange exchange, String type) {
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", type);
        headers.set("Cache-Control", "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        return headers;
    }

    /** Whether a body follows. */
    private static boolean begin(HttpExchange exchange, long bytes, boolean head) throws IOException {
        if (head) {
            exchange.getResponseHeaders().set("Content-Length", String.valueOf(bytes));
        }
        exchange.sendResponseHeaders(200, head ? -1 : bytes);
        return !head;
    }

    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }
}
