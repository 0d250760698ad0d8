package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.Closeable;
import java.io.IOException;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.crw.replay.FollowJson;
import org.sami.crw.session.archive.PictureRows;
import org.sami.crw.session.picture.SessionPictures;
import org.sami.spn.journal.TelemetryRow;

/**
 * Fetches the pictures of a session's boats from its server into a temporary folder here, one after the other, the newest first. A row that says that a picture is in the
 * server's folder is held back until the picture is in this one. Begins once somebody wants to see them: a console does not. For the link's thread.
 */
final class RemotePictures implements Closeable {
    private static final System.Logger LOG = System.getLogger(RemotePictures.class.getName());
    private static final int MOST_WAITING = 200;
    private static final long MOST_BYTES = 32L << 20;
    private static final long AGAIN_MS = 2000;
    private static final Duration LIMIT = Duration.ofMinutes(2); // of one picture
    private static final String FILE = "file";

    private final ServerTrust trust;
    private final ScheduledExecutorService thread;
    private final SessionPictures folder = SessionPictures.temporary();
    private final Deque<Held> waiting = new ArrayDeque<>(); // the newest first
    private final Thread leftovers = new Thread(this::delete, "pictures of the session");
    private String ticket = "";
    private @Nullable Source source;
    private boolean wanted;
    private boolean fetching;
    private boolean closed;

    /** The base that has them. */
    private record Source(SessionAddress address, HttpClient client) {
        static Source of(SessionAddress address, ServerTrust trust) {
            HttpClient.Builder builder = HttpClient.newBuilder();
            return new Source(
                    address,
                    address.secure()
                            ? builder.sslContext(trust.context(address)).build()
                            : builder.build());
        }
    }

    /** A row that is held back. */
    private record Held(TelemetryRow row, JsonNode json, Consumer<TelemetryRow> then) {
        String text(String member) {
            return json.path(member).asText();
        }
    }

    /**
     * Fetches nothing yet.
     *
     * @param thread the link's
     */
    RemotePictures(ServerTrust trust, ScheduledExecutorService thread) {
        this.trust = trust;
        this.thread = thread;
    }

    /** Somebody wants to see the pictures: they are fetched from now on, and deleted at the latest when this process ends. */
    void want() {
        if (!wanted) {
            wanted = true;
            Runtime.getRuntime().addShutdownHook(leftovers);
            next();
        }
    }

    private void delete() {
        try {
            folder.close();
        } catch (IOException left) {
            LOG.log(System.Logger.Level.WARNING, "pictures of the session are left in a temporary folder", left);
        }
    }

    /** Where the pictures are here. */
    SessionPictures folder() {
        return folder;
    }

    /** With this ticket a base gives pictures, for as long as this connection to it lasts. */
    void from(SessionAddress base, String now) {
        if (source == null || !source.address().equals(base)) {
            source = Source.of(base, trust);
        }
        ticket = now;
        next();
    }

    /** Whether a row says that a picture is in the server's folder. */
    static boolean isHeldBack(TelemetryRow row) {
        return row.kind().equals(PictureRows.PICTURE)
                && FollowJson.parse(row.json()).has(FILE);
    }

    /** Forgets what was to be fetched: all rows come again. */
    void restart() {
        waiting.clear();
    }

    /**
     * Fetches the picture of a row.
     *
     * @param then is given the row once the picture is here, or one that says why it will not come; on the link's thread
     */
    void fetch(TelemetryRow row, Consumer<TelemetryRow> then) {
        waiting.addFirst(new Held(row, FollowJson.parse(row.json()), then));
        if (waiting.size() > MOST_WAITING) {
            missed(waiting.removeLast(), MOST_WAITING + " newer pictures are fetched first");
        }
        next();
    }

    private void next() {
        Source from = source;
        if (!wanted || fetching || closed || from == null || ticket.isEmpty() || waiting.isEmpty()) {
            return;
        }
        Held one = waiting.removeFirst();
        Path file;
        try {
            file = folder.place(one.text(FILE));
        } catch (IOException | IllegalArgumentException fault) {
            missed(one, "it cannot be kept here: " + fault.getMessage());
            next();
            return;
        }
        if (Files.exists(file)) {
            one.then().accept(one.row());
            next();
            return;
        }
        fetching = true;
        String with = ticket;
        var unused = request(from, one, file.resolveSibling(file.getFileName() + ".part"))
                .whenComplete((response, fault) -> execute(() -> {
                    fetching = false;
                    arrived(one, file, with, response == null ? 0 : response.statusCode());
                }));
    }

    private CompletableFuture<HttpResponse<Path>> request(Source from, Held one, Path part) {
        String query = "boat=" + encoded(one.row().proxy()) + "&panorama=" + encoded(one.text("panorama")) + "&name="
                + encoded(one.text("name"));
        HttpRequest request = HttpRequest.newBuilder(from.address().page("picture?" + query))
                .header("Authorization", "Bearer " + ticket)
                .timeout(LIMIT)
                .build();
        return from.client()
                .sendAsync(
                        request,
                        response -> response.statusCode() == 200
                                        && response.headers()
                                                        .firstValueAsLong("Content-Length")
                                                        .orElse(Long.MAX_VALUE)
                                                <= MOST_BYTES
                                ? HttpResponse.BodySubscribers.ofFile(part)
                                : HttpResponse.BodySubscribers.replacing(part));
    }

    private static String encoded(String text) {
        return URLEncoder.encode(text, StandardCharsets.UTF_8);
    }

    /** A lost connection, a ticket that counts no longer and a busy server are no reason to give up. */
    private void arrived(Held one, Path file, String with, int status) {
        if (closed) {
            return;
        }
        if (status == 200) {
            try {
                Files.move(
                        file.resolveSibling(file.getFileName() + ".part"), file, StandardCopyOption.REPLACE_EXISTING);
                one.then().accept(one.row());
            } catch (IOException fault) {
                missed(one, "it cannot be kept here: " + fault.getMessage());
            }
            next();
        } else if (status == 404) {
            missed(one, "the base does not give this picture");
            next();
        } else {
            waiting.addFirst(one);
            if (ticket.equals(with)) {
                var unused = thread.schedule(this::next, AGAIN_MS, TimeUnit.MILLISECONDS);
            } else {
                next();
            }
        }
    }

    private static void missed(Held one, String why) {
        String json = JsonNodeFactory.instance
                .objectNode()
                .put("panorama", one.text("panorama"))
                .put("name", one.text("name"))
                .put("missed", why)
                .toString();
        one.then()
                .accept(new TelemetryRow(
                        one.row().atMillis(), one.row().proxy(), one.row().kind(), json));
    }

    private void execute(Runnable work) {
        try {
            thread.execute(work);
        } catch (RejectedExecutionException over) {
            // the session was left
        }
    }

    /** Deletes the pictures here. */
    @Override
    public void close() {
        closed = true;
        waiting.clear();
        delete();
        try {
            Runtime.getRuntime().removeShutdownHook(leftovers);
        } catch (IllegalStateException ending) {
            // the process ends: what it would do is done
        }
    }
}
