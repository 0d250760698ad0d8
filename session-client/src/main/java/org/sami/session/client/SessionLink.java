package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.net.ConnectException;
import java.net.http.HttpClient;
import java.security.cert.CertificateException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.sami.crw.replay.FollowJson;
import org.sami.crw.session.RefusedException;

/**
 * The link to a session's server (docs/session-link.md): logs in, sends requests and waits for their replies, connects again when the connection is lost. All of it on one
 * thread, which is the caller's and shared with what follows the session.
 */
final class SessionLink {
    private static final int VERSION = 1;
    private static final long FIRST_DELAY_MS = 1000;
    private static final long LONGEST_DELAY_MS = 8000;
    private static final long LOOK_MS = 1000;
    private static final long SILENT_NANOS = TimeUnit.SECONDS.toNanos(30);

    private final SessionAddress address;
    private final Login login;
    private final HttpClient client;
    private final LinkListener listener;
    private final ScheduledExecutorService thread;
    private final Map<Long, CompletableFuture<JsonNode>> open = new HashMap<>();
    private Optional<LinkSocket> socket = Optional.empty();
    private volatile long heardNanos = System.nanoTime();
    private boolean welcome; // logged in on this connection
    private boolean over;
    private long attempt; // of connecting; what comes from an earlier one is left alone
    private long requests;
    private long delayMillis = FIRST_DELAY_MS;

    SessionLink(
            SessionAddress address,
            Login login,
            ServerTrust trust,
            LinkListener listener,
            ScheduledExecutorService thread) {
        this.address = address;
        this.login = login;
        this.listener = listener;
        this.thread = thread;
        HttpClient.Builder builder = HttpClient.newBuilder();
        client = address.secure() ? builder.sslContext(trust.context(address)).build() : builder.build();
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
        heardNanos = System.nanoTime();
        Consumer<Runnable> ofThisAttempt = work -> execute(() -> {
            if (now == attempt && !over) {
                work.run();
            }
        });
        LinkSocket.connect(
                        client,
                        address,
                        text -> ofThisAttempt.accept(() -> take(text)),
                        () -> heardNanos = System.nanoTime(),
                        why -> ofThisAttempt.accept(() -> lose(why.isEmpty() ? "it was closed" : why)))
                .whenComplete((connected, fault) -> execute(() -> {
                    if (now != attempt || over) {
                        Optional.ofNullable(connected).ifPresent(LinkSocket::cut);
                    } else if (fault != null) {
                        lose(words(fault));
                    } else {
                        socket = Optional.of(connected);
                        hello(connected);
                    }
                }));
    }

    private String words(Throwable fault) {
        Throwable cause = fault;
        while (cause instanceof CompletionException && cause.getCause() != null) {
            cause = cause.getCause();
        }
        if (cause instanceof ConnectException) {
            return "no server answers at " + address;
        }
        Throwable root = cause;
        while (root.getCause() != null && !(root instanceof CertificateException)) {
            root = root.getCause();
        }
        return root.getMessage() == null ? root.toString() : root.getMessage();
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
        CompletableFuture<JsonNode> asked = open.get(message.path("id").asLong());
        if (type.equals("welcome")) {
            welcome = true;
            delayMillis = FIRST_DELAY_MS;
            listener.welcomed(message);
        } else if (type.equals("bye") || (type.equals("refused") && !welcome)) {
            end(message.path("text").asText());
        } else if (type.equals("done") && asked != null) {
            open.remove(message.path("id").asLong());
            asked.complete(message);
        } else if (type.equals("refused") && asked != null) {
            open.remove(message.path("id").asLong());
            asked.completeExceptionally(
                    new RefusedException(message.path("text").asText()));
        } else {
            listener.received(message);
        }
    }

    /** Asks for something; the reply completes the stage on the link's thread. Fails at once where there is no connection. */
    CompletionStage<JsonNode> request(ObjectNode message) {
        CompletableFuture<JsonNode> reply = new CompletableFuture<>();
        execute(() -> {
            if (!welcome || socket.isEmpty()) {
                reply.completeExceptionally(new RefusedException("there is no connection to " + address + " now"));
                return;
            }
            long id = ++requests;
            open.put(id, reply);
            socket.get().send(message.put("id", id).toString());
        });
        return reply;
    }

    private void look() {
        if (!over && socket.isPresent() && System.nanoTime() - heardNanos > SILENT_NANOS) {
            lose("nothing came for 30 s");
        }
    }

    /** Connects again later, as this connection leads to nothing; does nothing where it is lost already. */
    void again(String why) {
        if (welcome) {
            lose(why);
        }
    }

    /** Ends this connection and connects again later. */
    private void lose(String why) {
        attempt++; // what still comes of this one is late
        drop("the connection was lost before the answer came: look whether it was done");
        if (over) {
            return;
        }
        listener.lost(why);
        var unused = thread.schedule(this::connect, delayMillis, TimeUnit.MILLISECONDS);
        delayMillis = Math.min(LONGEST_DELAY_MS, delayMillis * 2);
    }

    private void drop(String why) {
        socket.ifPresent(LinkSocket::cut);
        socket = Optional.empty();
        welcome = false;
        List<CompletableFuture<JsonNode>> waiting = List.copyOf(open.values());
        open.clear();
        waiting.forEach(one -> one.completeExceptionally(new RefusedException(why)));
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
