package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledExecutorService;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sami.crw.operator.FollowFeed;
import org.sami.session.api.RefusedException;
import org.sami.spn.json.UnreadableJsonException;

/** Keeps the copy of a session up with what its server sends, over connections that may be lost. On the link's thread; {@link #request} and {@link #shown} from any. */
final class SessionFollower implements LinkListener {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm:ss");

    private final Login login;
    private final Executor front;
    private final Executor computing;
    private final RemoteListener listener;
    private final Supplier<LocalTime> wallClock;
    private final Runnable unclaimed;
    private final CompletableFuture<SessionCopy> first = new CompletableFuture<>();
    private final CompletableFuture<SessionCopy> shown = new CompletableFuture<>(); // with the rows of its boats
    private final SessionLink link;
    private final RemotePictures pictures;
    private final ServerTrust trust;
    private Optional<LocalTime> seen = Optional.empty();
    private boolean away;
    private String said = "";
    private volatile SessionAddress base;
    private volatile @Nullable TicketedBase holder; // null before the first login
    private volatile boolean loggedIn; // there now
    private volatile PersonRights rights = new PersonRights("", Set.of());

    /**
     * Follows nothing yet.
     *
     * @param unclaimed is run when the server has forgotten what was claimed: a connection has ended, or this person may drive no longer
     */
    SessionFollower(
            List<SessionAddress> bases,
            Login login,
            ServerTrust trust,
            Executor front,
            Executor computing,
            RemoteListener listener,
            Supplier<LocalTime> wallClock,
            ScheduledExecutorService thread,
            Runnable unclaimed) {
        this.login = login;
        this.front = front;
        this.computing = computing;
        this.listener = listener;
        this.wallClock = wallClock;
        this.unclaimed = unclaimed;
        base = bases.get(0);
        link = new SessionLink(bases, login, trust, this, thread);
        this.trust = trust;
        pictures = new RemotePictures(thread);
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

    /** The base that held the session last. From any thread. */
    SessionAddress base() {
        return base;
    }

    /** The base that holds the session, for what comes over HTTP; empty while there is no login. From any thread. */
    Optional<TicketedBase> holder() {
        return Optional.ofNullable(holder).filter(one -> loggedIn);
    }

    /** What the person may do, as its server said last. From any thread. */
    PersonRights rights() {
        return rights;
    }

    @Override
    public void welcomed(JsonNode message) {
        base = link.base();
        take(PersonRights.of(message), copy().isPresent());
        String ticket = message.path("ticket").asText();
        TicketedBase before = holder;
        TicketedBase now = before != null && before.address().equals(base)
                ? before.with(ticket)
                : TicketedBase.of(base, trust, ticket);
        holder = now;
        loggedIn = true;
        pictures.from(now);
        ObjectNode follow = ServerRequests.message("follow");
        copy().filter(known -> !known.id().isEmpty())
                .ifPresent(known -> follow.put("session", known.id()).put("after", known.reached()));
        link.request(follow).whenComplete((done, fault) -> {
            if (fault != null && !link.isLoggedIn()) {
                return; // the connection was lost before the reply: the link connects again
            }
            if (fault != null && copy().isEmpty()) {
                failed(RefusedException.reason(fault));
            } else if (fault != null) {
                link.again(RefusedException.reason(fault));
            } else {
                link.holds();
                if (away) {
                    comeBack();
                }
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

    private void comeBack() {
        away = false;
        said = "";
        listener.back(base);
    }

    @Override
    public void lost(String why, String trying) {
        loggedIn = false;
        unclaimed.run();
        say("connection lost (" + why + "), last seen " + lastSeen() + trying);
    }

    @Override
    public void waits(String words) {
        say(copy().isEmpty() ? words : "connection lost, last seen " + lastSeen() + "; " + words);
    }

    @Override
    public void quiet(boolean now) {
        if (now) {
            say("nothing comes from " + base + ", last seen " + lastSeen());
        } else if (away) {
            comeBack();
        }
    }

    private String lastSeen() {
        return seen.map(CLOCK::format).orElse("never");
    }

    /** Each sentence once, until the session is back. */
    private void say(String words) {
        away = true;
        if (!words.equals(said)) {
            said = words;
            listener.lost(words);
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
                    link.standsStill(known.standsStill());
                    if (message.path("set").has("bases")) {
                        link.know(known.bases());
                    }
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
        if (!now.has("drive")) {
            unclaimed.run();
        }
        if (other && tell) {
            listener.rights(now);
        }
    }

    private void begin(JsonNode message) throws IOException {
        Optional<SessionCopy> known = copy();
        if (known.isPresent() && !known.get().isOf(message)) {
            link.leaveOut("another session is at " + base + " now");
            return;
        }
        SessionCopy copy = known.isPresent()
                ? known.get()
                : new SessionCopy(message, base.toString(), front, computing, acknowledgements(), pictures);
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
