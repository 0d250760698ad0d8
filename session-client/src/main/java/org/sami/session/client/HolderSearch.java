package org.sami.session.client;

import java.net.http.HttpClient;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Asks the other bases which of them holds the session, while the connected base stands still because it is cut off from the journal. A standby answers at once that it is one. A base that
 * holds the session waits for a name: one that answers nothing within 2 s counts as the holder. On the link's thread.
 */
final class HolderSearch {
    private static final long EVERY_NANOS = TimeUnit.SECONDS.toNanos(3);
    private static final Duration CONNECTING = Duration.ofSeconds(5);
    private static final long HEARS_MS = 2000;

    private final ScheduledExecutorService thread;
    private final Function<SessionAddress, HttpClient> clients;
    private final Consumer<SessionAddress> found;
    private boolean needed;
    private boolean looking;
    private long lookedNanos;
    private int looks;

    /**
     * A search that is not needed yet.
     *
     * @param found is given a base that says nothing of being a standby
     */
    HolderSearch(
            ScheduledExecutorService thread,
            Function<SessionAddress, HttpClient> clients,
            Consumer<SessionAddress> found) {
        this.thread = thread;
        this.clients = clients;
        this.found = found;
    }

    /** The search is needed while the connected base stands still. */
    void need(boolean now) {
        needed = now;
    }

    /** Asks the next of the other bases, if the last one was asked long enough ago. */
    void look(List<SessionAddress> others, long nowNanos) {
        if (!needed || looking || others.isEmpty() || nowNanos - lookedNanos < EVERY_NANOS) {
            return;
        }
        looking = true;
        lookedNanos = nowNanos;
        SessionAddress one = others.get(looks++ % others.size());
        AtomicBoolean spoke = new AtomicBoolean();
        LinkSocket.connect(
                        clients.apply(one),
                        one,
                        CONNECTING,
                        text -> spoke.set(true),
                        () -> {},
                        closed -> spoke.set(true))
                .whenComplete((socket, fault) -> {
                    long wait = fault == null ? HEARS_MS : 0;
                    var unused = thread.schedule(
                            () -> looked(one, Optional.ofNullable(socket), spoke.get()), wait, TimeUnit.MILLISECONDS);
                });
    }

    private void looked(SessionAddress one, Optional<LinkSocket> socket, boolean isStandby) {
        looking = false;
        socket.ifPresent(LinkSocket::cut);
        if (needed && socket.isPresent() && !isStandby) {
            found.accept(one);
        }
    }
}
