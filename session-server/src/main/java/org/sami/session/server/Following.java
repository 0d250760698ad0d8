package org.sami.session.server;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.sami.crw.session.Session;
import org.sami.session.api.RefusedException;
import org.sami.session.rows.Table;
import org.sami.spn.journal.JournalHeader;

/** The fronts that follow the session with an engine of their own, and the last item that each was sent. For the server's thread. */
final class Following {
    /** Tables of which such a front makes its own. */
    private static final Set<String> FOLLOWED =
            Set.of("missions", "decisions", "buttons", "areas", "paths", "phases", "readings", "pictures");

    private final Session session;
    private final JournalFeed feed;
    private final Executor thread;
    private final Map<Front, Long> sent = new HashMap<>();

    Following(Session session, JournalFeed feed, Executor thread) {
        this.session = session;
        this.feed = feed;
        this.thread = thread;
    }

    /** Lets a front follow from now on. It is sent the whole state, unless it has the feed up to a number from which it can go on. */
    CompletionStage<CommandReply> follow(Front front, FrontMessage message) throws MalformedMessageException {
        Optional<String> earlier = message.textIfThere("session");
        if (earlier.isPresent() && feed.has(earlier.get(), message.number("after"))) {
            sent.put(front, message.number("after"));
            front.rows().restart();
            return CompletableFuture.completedFuture(CommandReply.of("goes on"));
        }
        JournalHeader header = session.setup()
                .journal()
                .header()
                .orElseThrow(() ->
                        new RefusedException("This session cannot be followed: its plans' documents are not known"));
        CompletableFuture<CommandReply> begun = new CompletableFuture<>();
        session.execute(() -> {
            try {
                ObjectNode beginning = feed.beginning(
                        header, session.host().capture(), session.scheduler().nowMs());
                thread.execute(() -> {
                    front.send(beginning.toString());
                    sent.put(front, beginning.path("n").asLong());
                    front.rows().restart(); // those before had nothing to be shown in
                    begun.complete(CommandReply.of("begins"));
                });
            } catch (IllegalStateException waits) {
                begun.completeExceptionally(new RefusedException(String.valueOf(waits.getMessage())));
            }
        });
        return begun;
    }

    boolean isFollowing(Front front) {
        return sent.containsKey(front);
    }

    void left(Front front) {
        sent.remove(front);
    }

    /** Whether a front needs a table. */
    boolean needs(Front front, Table table) {
        return !(isFollowing(front) && FOLLOWED.contains(table.name()));
    }

    /** Sends a front the items that are new to it. A front that is too far behind is cut off, and begins again. */
    void send(Front front) {
        Long number = sent.get(front);
        if (number == null) {
            return;
        }
        if (feed.lacks(number)) {
            front.cut();
            return;
        }
        for (Optional<ObjectNode> next = feed.after(number); next.isPresent(); next = feed.after(number)) {
            front.send(next.get().toString());
            number = next.get().path("n").asLong();
            sent.put(front, number);
        }
    }

    /** Sends a front every item that follows from earlier commands, then runs work on the server's thread. */
    void afterAll(Front front, Runnable then) {
        if (!isFollowing(front)) {
            then.run();
            return;
        }
        session.caughtUp()
                .thenCompose(caught -> session.models().shown())
                .whenComplete((caught, closed) -> thread.execute(() -> {
                    send(front);
                    then.run();
                }));
    }
}
