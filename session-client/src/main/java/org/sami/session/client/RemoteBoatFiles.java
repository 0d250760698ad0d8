package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.http.HttpHeaders;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Supplier;
import org.sami.boat.link.KeptFile;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.file.FileFetchException;
import org.sami.session.api.LinkedBoat;

/**
 * The logs of a boat of a session in another process, which its base asks of the boat and gives over HTTP (docs/session-link.md). After a take-over they come from the other base. What is
 * refused fails in the base's words; a lost connection and a boat that the base does not reach may be tried again.
 */
final class RemoteBoatFiles implements BoatFileSource {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int OK = 200;
    private static final int UNAUTHORIZED = 401;
    private static final int NOT_FOUND = 404;
    private static final int UNAVAILABLE = 503;
    private static final long MOST_BYTES = 16 << 20; // a list of 100,000 files
    private static final int MOST_WORDS = 300;
    private static final String NO_LINK = "the base has no link to a boat ";
    private static final String PAGE_WITHOUT = "Nothing is here"; // of a base of before, and of one that stands by

    private final LinkedBoat boat;
    private final Supplier<Optional<TicketedBase>> holder;
    private Optional<CompletableFuture<HttpResponse<byte[]>>> asked =
            Optional.empty(); // this and the next are guarded by this
    private boolean closed;

    /**
     * Logs of a boat.
     *
     * @param holder the base that holds the session at the time, empty while there is no login; from any thread
     */
    RemoteBoatFiles(LinkedBoat boat, Supplier<Optional<TicketedBase>> holder) {
        this.boat = boat;
        this.holder = holder;
    }

    @Override
    public void open() {
        // each request finds the base that holds the session by then
    }

    @Override
    public String boatId() {
        return boat.boat();
    }

    @Override
    public List<KeptFile> list(String kind) throws IOException {
        if (!kind.equals(KeptFile.LOG)) {
            throw new FileFetchException("a base gives the logs of its boats, not each " + kind);
        }
        JsonNode answer = JSON.readTree(get("logs?boat=" + TicketedBase.encoded(boat.boat())));
        JsonNode listed = answer.path("files");
        if (!listed.isArray()) {
            throw new FileFetchException("the base answers with no list of logs");
        }
        List<KeptFile> files = new ArrayList<>();
        try {
            for (JsonNode one : listed) {
                files.add(new KeptFile(
                        one.path("name").asText(),
                        KeptFile.LOG,
                        one.path("bytes").asLong(),
                        one.path("sha256").asText()));
            }
        } catch (IllegalArgumentException unfit) {
            throw new FileFetchException("the base lists a log that is none: " + unfit.getMessage());
        }
        return files;
    }

    @Override
    public byte[] piece(String name, long offset, int atMost) throws IOException {
        return get("log?boat=" + TicketedBase.encoded(boat.boat()) + "&name=" + TicketedBase.encoded(name) + "&from="
                + offset + "&most=" + atMost);
    }

    private byte[] get(String path) throws IOException {
        TicketedBase from = holder.get().orElseThrow(() -> new IOException("the session is not connected now"));
        HttpResponse<byte[]> response;
        try {
            response = begin(from, path).get();
        } catch (ExecutionException fault) {
            throw fault.getCause() instanceof IOException broken ? broken : new IOException(fault.getCause());
        } catch (CancellationException over) {
            throw new IOException("closed", over);
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", ended);
        }
        switch (response.statusCode()) {
            case OK -> {
                if (!isRead(response.headers())) {
                    throw new FileFetchException("the base sends more than " + MOST_BYTES
                            + " bytes at once, or does not say how many: it is not read");
                }
                return response.body();
            }
            case UNAUTHORIZED -> throw new IOException("the connection to the session is lost");
            case UNAVAILABLE -> throw new IOException(words(response).orElse("the base is busy with other logs"));
            default -> {
                if (response.statusCode() == NOT_FOUND && mayComeLater(from, response)) {
                    throw new IOException(words(response).orElse("another base takes the session over"));
                }
                throw new FileFetchException(words(response)
                        .orElse("the base at " + from.address() + " gives no logs; bring it to this version"));
            }
        }
    }

    private synchronized CompletableFuture<HttpResponse<byte[]>> begin(TicketedBase from, String path)
            throws IOException {
        if (closed) {
            throw new IOException("closed");
        }
        CompletableFuture<HttpResponse<byte[]>> next =
                from.client().sendAsync(from.request(path), RemoteBoatFiles::body);
        asked = Optional.of(next);
        return next;
    }

    /** A base sends no more than this; what is longer is not read. */
    private static HttpResponse.BodySubscriber<byte[]> body(HttpResponse.ResponseInfo response) {
        return isRead(response.headers())
                ? HttpResponse.BodySubscribers.ofByteArray()
                : HttpResponse.BodySubscribers.replacing(new byte[0]);
    }

    private static boolean isRead(HttpHeaders headers) {
        return headers.firstValueAsLong("Content-Length").orElse(Long.MAX_VALUE) <= MOST_BYTES;
    }

    /** Whether a 404 is that of a base without a link to the boat yet, or of one that no longer holds the session: the login there has ended or is another by now. */
    private boolean mayComeLater(TicketedBase asked, HttpResponse<byte[]> response) {
        boolean another = holder.get().filter(asked::equals).isEmpty();
        return text(response).startsWith(NO_LINK) || (another && text(response).equals(PAGE_WITHOUT));
    }

    private static String text(HttpResponse<byte[]> response) {
        return new String(response.body(), StandardCharsets.UTF_8).strip();
    }

    private static Optional<String> words(HttpResponse<byte[]> response) {
        String text = text(response);
        boolean plain = response.headers().firstValue("Content-Type").orElse("").startsWith("text/plain");
        boolean page = response.statusCode() == NOT_FOUND && text.equals(PAGE_WITHOUT);
        return plain && !text.isEmpty() && text.length() <= MOST_WORDS && !page ? Optional.of(text) : Optional.empty();
    }

    @Override
    public synchronized void close() {
        closed = true;
        asked.ifPresent(one -> one.cancel(true));
    }
}
