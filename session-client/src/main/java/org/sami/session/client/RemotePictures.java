package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.io.Closeable;
import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.session.follow.FollowJson;
import org.sami.session.record.PictureRows;
import org.sami.session.record.SessionPictures;
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
    private static final String FILE = "file";

    private final ScheduledExecutorService thread;
    private final SessionPictures folder = SessionPictures.temporary();
    private final Deque<Held> waiting = new ArrayDeque<>(); // the newest first
    private final Thread leftovers = new Thread(this::delete, "pictures of the session");
    private @Nullable TicketedBase base;
    private @Nullable CompletableFuture<?> underWay;
    private boolean wanted;
    private boolean closed;

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
    RemotePictures(ScheduledExecutorService thread) {
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

    /** They come from this base from now on. What is under way from an earlier login is given up: where its base has lost its power, nothing would ever end it. */
    void from(TicketedBase now) {
        base = now;
        giveUp();
        next();
    }

    private void giveUp() {
        if (underWay != null) {
            underWay.cancel(true);
        }
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
        TicketedBase from = base;
        if (!wanted || underWay != null || closed || from == null || waiting.isEmpty()) {
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
        CompletableFuture<HttpResponse<Path>> asked =
                request(from, one, file.resolveSibling(file.getFileName() + ".part"));
        underWay = asked;
        var unused = asked.whenComplete((response, fault) -> execute(() -> {
            underWay = null;
            arrived(one, file, from, response == null ? 0 : response.statusCode());
        }));
    }

    private CompletableFuture<HttpResponse<Path>> request(TicketedBase from, Held one, Path part) {
        String query = "boat=" + TicketedBase.encoded(one.row().proxy()) + "&panorama="
                + TicketedBase.encoded(one.text("panorama")) + "&name=" + TicketedBase.encoded(one.text("name"));
        return from.client()
                .sendAsync(
                        from.request("picture?" + query),
                        response -> response.statusCode() == 200
                                        && response.headers()
                                                        .firstValueAsLong("Content-Length")
                                                        .orElse(Long.MAX_VALUE)
                                                <= MOST_BYTES
                                ? HttpResponse.BodySubscribers.ofFile(part)
                                : HttpResponse.BodySubscribers.replacing(part));
    }

    /** A lost connection, a ticket that counts no longer and a busy server are no reason to give up. */
    private void arrived(Held one, Path file, TicketedBase from, int status) {
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
            if (from.equals(base)) {
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
        giveUp();
        waiting.clear();
        delete();
        try {
            Runtime.getRuntime().removeShutdownHook(leftovers);
        } catch (IllegalStateException ending) {
            // the process ends: what it would do is done
        }
    }
}
