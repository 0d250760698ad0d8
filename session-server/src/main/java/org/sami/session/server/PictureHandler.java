package org.sami.session.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpMethod;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.Fields;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.picture.photo.PhotoReader;

/**
 * Serves the pictures of boats to fronts that have logged in: {@code /picture?boat=B&panorama=P&name=N}, with {@code &small} a thumbnail, and the front's ticket as
 * {@code Authorization: Bearer TICKET}. Nothing of it may be stored on its way. Pictures are read one after the other on a thread of their own. Passes on all other requests.
 */
final class PictureHandler extends Handler.Wrapper implements AutoCloseable {
    private static final String BEARER = "Bearer ";
    private static final int MOST_WAITING = 100;
    private static final int IDLE_S = 10;

    /** Whole pictures that are on their way at once: each is in memory, up to 32 MiB, until a slow link has taken it. */
    private static final int MOST_WHOLE = 4;

    private final Supplier<List<PanoramaPictures>> taken;
    private final Tickets tickets;
    private final Thumbnails thumbnails = new Thumbnails();
    private final Semaphore whole = new Semaphore(MOST_WHOLE);
    private final ThreadPoolExecutor reader =
            new ThreadPoolExecutor(1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(MOST_WAITING), work -> {
                Thread thread = new Thread(work, "session server pictures");
                thread.setDaemon(true);
                return thread;
            });

    /**
     * Serves pictures.
     *
     * @param taken the pictures that there are; from any thread
     */
    PictureHandler(Supplier<List<PanoramaPictures>> taken, Tickets tickets) {
        this.taken = taken;
        this.tickets = tickets;
        reader.allowCoreThreadTimeOut(true);
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        if (!Request.getPathInContext(request).equals("/picture") || !HttpMethod.GET.is(request.getMethod())) {
            return super.handle(request, response, callback);
        }
        response.getHeaders()
                .put("Content-Security-Policy", "default-src 'none'; sandbox; frame-ancestors 'none'")
                .put("X-Content-Type-Options", "nosniff")
                .put("Referrer-Policy", "no-referrer")
                .put("Cross-Origin-Resource-Policy", "same-origin")
                .put(HttpHeader.CACHE_CONTROL, "no-store");
        String shown = Optional.ofNullable(request.getHeaders().get(HttpHeader.AUTHORIZATION))
                .orElse("");
        if (!shown.startsWith(BEARER) || !tickets.isValid(shown.substring(BEARER.length()))) {
            send(response, HttpStatus.UNAUTHORIZED_401, new byte[0], callback);
            return true;
        }
        Fields asked = Request.extractQueryParameters(request);
        Optional<Path> file = file(asked);
        if (file.isEmpty()) {
            send(response, HttpStatus.NOT_FOUND_404, new byte[0], callback);
            return true;
        }
        try {
            reader.execute(
                    asked.get("small") != null
                            ? () -> serve(() -> thumbnails.of(file.get()), response, callback)
                            : () -> serveWhole(file.get(), response, callback));
        } catch (RejectedExecutionException tooMany) {
            refuse(response, callback);
        }
        return true;
    }

    private static void refuse(Response response, Callback callback) {
        response.getHeaders().put(HttpHeader.RETRY_AFTER, 1);
        send(response, HttpStatus.SERVICE_UNAVAILABLE_503, new byte[0], callback);
    }

    private void serveWhole(Path file, Response response, Callback callback) {
        if (!whole.tryAcquire()) {
            refuse(response, callback);
            return;
        }
        AtomicBoolean released = new AtomicBoolean(); // a write that fails at once may be said twice
        serve(
                () -> whole(file),
                response,
                Callback.from(
                        () -> {
                            if (!released.getAndSet(true)) {
                                whole.release();
                            }
                        },
                        callback));
    }

    /** What is to be sent; empty where it is no picture. */
    @FunctionalInterface
    private interface Content {
        Optional<byte[]> read() throws IOException;
    }

    /** The file of a picture that is here; no other file can be named. */
    private Optional<Path> file(Fields asked) {
        return taken.get().stream()
                .filter(one -> one.boat().equals(asked.getValue("boat"))
                        && one.panorama().equals(asked.getValue("panorama")))
                .flatMap(one -> one.pictures().stream())
                .filter(one -> one.name().equals(asked.getValue("name")))
                .flatMap(one -> one.file().stream())
                .findFirst();
    }

    private static void serve(Content from, Response response, Callback callback) {
        try {
            Optional<byte[]> content = from.read();
            Optional<String> type = content.flatMap(PictureHandler::type);
            if (content.isEmpty() || type.isEmpty()) {
                send(response, HttpStatus.NOT_FOUND_404, new byte[0], callback);
            } else {
                response.getHeaders().put(HttpHeader.CONTENT_TYPE, type.get());
                send(response, HttpStatus.OK_200, content.get(), callback);
            }
        } catch (IOException gone) {
            send(response, HttpStatus.NOT_FOUND_404, new byte[0], callback);
        } catch (RuntimeException | Error fault) {
            callback.failed(fault);
            throw fault;
        }
    }

    private static Optional<byte[]> whole(Path file) throws IOException {
        return Files.size(file) > PhotoReader.MOST_BYTES ? Optional.empty() : Optional.of(Files.readAllBytes(file));
    }

    /** JPEG or PNG by its first bytes; a boat may have sent anything. */
    private static Optional<String> type(byte[] content) {
        if (content.length > 3 && content[0] == (byte) 0xff && content[1] == (byte) 0xd8) {
            return Optional.of("image/jpeg");
        }
        boolean png = content.length > 8
                && content[0] == (byte) 0x89
                && content[1] == 'P'
                && content[2] == 'N'
                && content[3] == 'G';
        return png ? Optional.of("image/png") : Optional.empty();
    }

    private static void send(Response response, int status, byte[] content, Callback callback) {
        response.setStatus(status);
        response.getHeaders().put(HttpHeader.CONTENT_LENGTH, content.length);
        response.write(true, ByteBuffer.wrap(content), callback);
    }

    @Override
    public void close() {
        reader.shutdownNow();
    }
}
