package org.sami.session.server;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;
import java.util.function.Supplier;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.Fields;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.picture.photo.PhotoReader;
import org.sami.session.person.Person;

/**
 * Serves the pictures of boats to fronts that have logged in: {@code /picture?boat=B&panorama=P&name=N}, with {@code &small} a thumbnail. Whoever is logged in
 * may see them. They are read one after the other.
 */
final class PictureHandler extends TicketHandler {
    /** Whole pictures that are on their way at once: each is in memory, up to 32 MiB, until a slow link has taken it. */
    private static final int MOST_WHOLE = 4;

    private final Supplier<List<PanoramaPictures>> taken;
    private final Thumbnails thumbnails = new Thumbnails();
    private final Semaphore whole = new Semaphore(MOST_WHOLE);

    /**
     * Serves pictures.
     *
     * @param taken the pictures that there are; from any thread
     */
    PictureHandler(
            Supplier<List<PanoramaPictures>> taken,
            Function<String, Optional<Person>> tickets,
            SessionBases bases,
            ThreadGuard guard) {
        super(tickets, bases, "session server pictures", 1, guard);
        this.taken = taken;
    }

    @Override
    boolean serves(String path) {
        return path.equals("/picture");
    }

    @Override
    void serve(Person person, Request request, Response response, Callback callback) {
        Fields asked = Request.extractQueryParameters(request);
        Optional<Path> file = file(asked);
        if (file.isEmpty()) {
            send(response, HttpStatus.NOT_FOUND_404, new byte[0], callback);
            return;
        }
        work(
                response,
                callback,
                asked.get("small") != null
                        ? () -> serve(() -> thumbnails.of(file.get()), response, callback)
                        : () -> serveWhole(file.get(), response, callback));
    }

    private void serveWhole(Path file, Response response, Callback callback) {
        if (!whole.tryAcquire()) {
            busy(response, callback);
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
}
