package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledExecutorService;
import java.util.function.Supplier;
import org.sami.crw.operator.FollowFeed;
import org.sami.crw.session.RefusedException;
import org.sami.spn.json.UnreadableJsonException;

/** Keeps the copy of a session up with what its server sends, over connections that may be lost. On the link's thread; {@link #request} and {@link #shown} from any. */
final class SessionFollower implements LinkListener {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss");

    private final SessionAddress address;
    private final Login login;
    private final Executor front;
    private final Executor computing;
    private final RemoteListener listener;
    private final Supplier<LocalTime> wallClock;
    private final Runnable disconnected;
    private final CompletableFuture<SessionCopy> first = new CompletableFuture<>();
    private final CompletableFuture<SessionCopy> shown = new CompletableFuture<>(); // with the rows of its boats
    private final SessionLink link;
    private final RemotePictures pictures;
    private Optional<LocalTime> seen = Optional.empty();
    private boolean away;
    private volatile PersonRights rights = new PersonRights("", Set.of());

    /**
     * Follows nothing yet.
     *
     * @param disconnected is run when a connection has ended, and the server has forgotten what was claimed by it
     */
    SessionFollower(
            SessionAddress address,
            Login login,
            ServerTrust trust,
            Executor front,
            Executor computing,
            RemoteListener listener,
            Supplier<LocalTime> wallClock,
            ScheduledExecutorService thread,
            Runnable disconnected) {
        this.address = address;
        this.login = login;
        this.front = front;
        this.computing = computing;
        this.listener = listener;
        this.wallClock = wallClock;
        this.disconnected = disconnected;
        link = new SessionLink(address, login, trust, this, thread);
        pictures = new RemotePictures(address, trust, thread);
    }

    /** Connects, and keeps at it. */
    void start() {
        link.start();
    }

    /** Completes with the copy once it has the session's state and boats; fails with the reason where there will be none. */
    CompletableFuture<SessionCopy> shown() {
        return shown;
    }

    /** Asks the server for something; the reply arrives on the link's thread. */
    CompletionStage<JsonNode> request(ObjectNode message) {
        return link.request(message);
    }

    /** Leaves the session. */
    void close() {
        link.close();
        pictures.close();
    }

    /** Fetches pictures from now on. */
    void wantPictures() {
        pictures.want();
    }

    /** What the person may do, as its server said last. From any thread. */
    PersonRights rights() {
        return rights;
    }

    @Override
    public void welcomed(JsonNode message) {
        take(PersonRights.of(message), copy().isPresent());
        pictures.ticket(message.path("ticket").asText());
        ObjectNode follow = ServerRequests.message("follow");
        copy().filter(known -> !known.id().isEmpty())
                .ifPresent(known -> follow.put("session", known.id()).put("after", known.reached()));
        link.request(follow).whenComplete((done, fault) -> {
            if (fault != null && copy().isEmpty()) {
                failed(RefusedException.reason(fault));
            } else if (fault != null) {
                link.again(RefusedException.reason(fault));
            } else if (away) {
                away = false;
                listener.back();
            }
        });
    }

    @Override
    public void received(JsonNode message) {
        seen = Optional.of(wallClock.get());
        try {
            take(message);
        } catch (UnreadableJsonException | IOException | IllegalArgumentException | IllegalStateException fault) {
            failed(fault.getMessage() == null ? fault.toString() : fault.getMessage());
        }
    }

    @Override
    public void lost(String why) {
        disconnected.run();
        if (copy().isEmpty()) {
            failed(why);
        } else if (!away) {
            away = true;
            listener.lost("connection lost (" + why + "), last seen "
                    + seen.map(CLOCK::format).orElse("never") + "; it is tried again");
        }
    }

    @Override
    public void ended(String why) {
        failed(why);
    }

    private void take(JsonNode message) throws IOException, UnreadableJsonException {
        switch (message.path("t").asText()) {
            case "session" -> begin(message);
            case "journal" -> {
                if (copy().isPresent()) {
                    copy().get().journal(message);
                }
            }
            case "rows" ->
                copy().ifPresent(known -> {
                    known.rows(message);
                    shown.complete(known);
                });
            case "rights" -> take(PersonRights.of(message), true);
            case "news" -> {
                if (!message.path("by").asText().equals(login.name())) {
                    listener.news(message.path("text").asText());
                }
            }
            default -> {
                // this version does not need it
            }
        }
    }

    private void take(PersonRights now, boolean tell) {
        boolean other = !now.equals(rights);
        rights = now;
        if (other && tell) {
            listener.rights(now);
        }
    }

    private void begin(JsonNode message) throws IOException {
        Optional<SessionCopy> known = copy();
        if (known.isPresent() && !known.get().isOf(message)) {
            throw new IOException("another session is at " + address + " now");
        }
        SessionCopy copy = known.isPresent()
                ? known.get()
                : new SessionCopy(message, address.toString(), front, computing, acknowledgements(), pictures);
        copy.begin(message);
        first.complete(copy);
    }

    private FollowFeed.Acknowledgements acknowledgements() {
        return new FollowFeed.Acknowledgements() {
            @Override
            public void message(long number) {
                acknowledge("message", number);
            }

            @Override
            public void alarm(long number) {
                acknowledge("alarm", number);
            }
        };
    }

    private void acknowledge(String what, long number) {
        link.request(ServerRequests.message("acknowledge").put(what, number)).exceptionally(fault -> {
            listener.news("not acknowledged: " + RefusedException.reason(fault));
            return JsonNodeFactory.instance.nullNode();
        });
    }

    /** Nothing comes of this connection, ever. */
    private void failed(String why) {
        first.completeExceptionally(new RefusedException(why));
        if (!shown.completeExceptionally(new RefusedException(why))) {
            listener.ended(why);
        }
        link.close();
    }

    private Optional<SessionCopy> copy() {
        return first.isDone() && !first.isCompletedExceptionally() ? Optional.of(first.join()) : Optional.empty();
    }
}
