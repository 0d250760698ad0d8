package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.session.api.RefusedException;
import org.sami.session.follow.FollowJson;

/**
 * The link to a session's server (docs/session-link.md): logs in, sends requests and waits for their replies, connects again when the connection is lost, to whichever of the session's bases
 * holds it. All of it on one thread, which is the caller's and shared with what follows the session.
 */
final class SessionLink {
    private static final int VERSION = 1;
    private static final Duration COMPARING = Duration.ofSeconds(60); // somebody may compare a certificate meanwhile
    private static final Duration CONNECTING = Duration.ofSeconds(5);
    private static final long LOOK_MS = 250;

    private final KnownBases bases;
    private final Login login;
    private final ServerTrust trust;
    private final BaseClients clients;
    private final LinkListener listener;
    private final ScheduledExecutorService thread;
    private final OpenRequests requests = new OpenRequests();
    private final ServerPulse pulse = new ServerPulse();
    private final HolderSearch search;
    private Optional<LinkSocket> socket = Optional.empty();
    private boolean welcome; // logged in on this connection
    private boolean welcomed; // on any
    private long epochHere; // of the base at hand, as it says
    private boolean over;
    private long attempt; // of connecting; what comes from an earlier one is left alone

    SessionLink(
            List<SessionAddress> bases,
            Login login,
            ServerTrust trust,
            LinkListener listener,
            ScheduledExecutorService thread) {
        this.bases = new KnownBases(bases);
        this.login = login;
        this.trust = trust;
        clients = new BaseClients(trust);
        this.listener = listener;
        this.thread = thread;
        search = new HolderSearch(thread, clients, this::leaveFor);
    }

    /** Connects, and keeps at it. */
    void start() {
        execute(this::connect);
        var unused = thread.scheduleWithFixedDelay(this::look, LOOK_MS, LOOK_MS, TimeUnit.MILLISECONDS);
    }

    private void execute(Runnable work) {
        try {
            thread.execute(work);
        } catch (RejectedExecutionException closed) {
            // nobody waits for it any longer
        }
    }

    private void connect() {
        if (over) {
            return;
        }
        long now = ++attempt;
        pulse.heard();
        SessionAddress address = bases.current();
        Consumer<Runnable> ofThisAttempt = work -> execute(() -> {
            if (now == attempt && !over) {
                work.run();
            }
        });
        LinkSocket.connect(
                        clients.apply(address),
                        address,
                        welcomed ? CONNECTING : COMPARING,
                        text -> ofThisAttempt.accept(() -> take(text)),
                        pulse::heard,
                        why -> ofThisAttempt.accept(() -> lose(why.isEmpty() ? "it was closed" : why)))
                .whenComplete((connected, fault) -> execute(() -> {
                    if (now != attempt || over) {
                        Optional.ofNullable(connected).ifPresent(LinkSocket::cut);
                    } else if (fault != null) {
                        lose(LinkFaults.words(fault, address));
                    } else {
                        socket = Optional.of(connected);
                        hello(connected);
                    }
                }));
    }

    private void hello(LinkSocket connected) {
        ObjectNode hello = JsonNodeFactory.instance
                .objectNode()
                .put("t", "hello")
                .put("v", VERSION)
                .put("name", login.name());
        if (!login.key().isEmpty()) {
            hello.put("key", login.key());
        }
        connected.send(hello.toString());
    }

    private void take(String text) {
        JsonNode message = FollowJson.parse(text);
        String type = message.path("t").asText();
        if (type.equals("welcome")) {
            welcome(message);
        } else if (type.equals("standby") && !welcome) {
            standby(message);
        } else if (type.equals("bye")) {
            end(message.path("text").asText());
        } else if (type.equals("refused") && !welcome) {
            leaveOut(message.path("text").asText());
        } else if (!requests.settle(message)) {
            listener.received(message);
        }
    }

    private void welcome(JsonNode message) {
        long epoch = message.path("epoch").asLong();
        if (bases.isSuperseded(epoch)) {
            lose(bases.current() + " held the session before, and another base does now");
            return;
        }
        epochHere = epoch;
        trust.askNoLonger();
        pulse.welcomed(message);
        welcome = true;
        welcomed = true;
        listener.welcomed(message);
    }

    /** The base at hand has the session that is followed. */
    void holds() {
        if (welcome) {
            bases.holds(epochHere);
        }
    }

    private void standby(JsonNode message) {
        know(message.path("bases"));
        String words = bases.current() + ", a standby: " + message.path("text").asText();
        attempt++;
        drop(words);
        bases.failed(words, true);
        listener.waits(words + trying());
        tryNext();
    }

    /** Takes up the bases that a base, which is trusted, names with their certificates. */
    void know(Iterable<JsonNode> rows) {
        bases.add(AnnouncedBases.read(rows, trust));
    }

    /** Where the session is, or is looked for. On the link's thread. */
    SessionAddress base() {
        return bases.current();
    }

    private String trying() {
        return bases.areSeveral()
                ? "; trying "
                        + bases.all().stream().map(SessionAddress::toString).collect(Collectors.joining(", "))
                : "; it is tried again";
    }

    /** Asks for something; the reply completes the stage on the link's thread. Fails at once where there is no connection. */
    CompletionStage<JsonNode> request(ObjectNode message) {
        CompletableFuture<JsonNode> reply = new CompletableFuture<>();
        execute(() -> {
            if (!welcome || socket.isEmpty()) {
                reply.completeExceptionally(
                        new RefusedException("there is no connection to " + bases.current() + " now"));
                return;
            }
            socket.get().send(message.put("id", requests.add(reply)).toString());
        });
        return reply;
    }

    private void look() {
        if (over || socket.isEmpty()) {
            return;
        }
        Optional<String> silent = pulse.lost(welcome, bases.areSeveral());
        if (silent.isPresent()) {
            lose(silent.get(), true);
        } else if (welcome) {
            pulse.turned().ifPresent(listener::quiet);
        }
        if (welcome) {
            search.look(bases.others(), System.nanoTime());
        }
    }

    /** Whether the base at hand says that nothing goes on in its session: another may hold it. On the link's thread. */
    void standsStill(boolean now) {
        search.need(now);
    }

    private void leaveFor(SessionAddress other) {
        if (welcome && !over) {
            String left = bases.current() + " stands still";
            bases.turnTo(other);
            lose(left);
        }
    }

    /** Whether the server has let this front in, on the connection that there is now. */
    boolean isLoggedIn() {
        return welcome;
    }

    /** Connects again later, as this connection leads to nothing; does nothing where it is lost already. */
    void again(String why) {
        if (welcome) {
            lose(why);
        }
    }

    /** Ends this connection and connects again, to this base or another. */
    private void lose(String why) {
        lose(why, false);
    }

    private void lose(String why, boolean silent) {
        boolean stood = welcome;
        attempt++; // what still comes of this one is late
        drop("the connection was lost before the answer came: look whether it was done");
        if (over) {
            return;
        }
        if (stood) {
            long wait = bases.lost(silent);
            listener.lost(why, trying());
            connectIn(wait);
            return;
        }
        bases.failed(why, false);
        if (!welcomed && bases.isRoundOver() && bases.nobodyWaits()) {
            end(bases.faults());
            return;
        }
        tryNext();
    }

    private void tryNext() {
        connectIn(bases.next());
    }

    private void connectIn(long millis) {
        var unused = thread.schedule(this::connect, millis, TimeUnit.MILLISECONDS);
    }

    /** The base at hand is none for this front: it is never tried again. The link ends where there is no other. */
    void leaveOut(String why) {
        SessionAddress left = bases.current();
        if (!bases.leaveOut()) {
            end(why);
            return;
        }
        attempt++;
        drop(why);
        listener.waits(left + ": " + why + trying());
        connectIn(0);
    }

    private void drop(String why) {
        socket.ifPresent(LinkSocket::cut);
        socket = Optional.empty();
        welcome = false;
        search.need(false);
        requests.drop(why);
    }

    private void end(String why) {
        over = true;
        drop(why);
        listener.ended(why);
    }

    /** Ends it; on the link's thread. */
    void close() {
        over = true;
        socket.ifPresent(one -> one.close().whenComplete((sent, fault) -> one.cut()));
        socket = Optional.empty();
        drop("the session is closed here");
    }
}
