package org.sami.session.server;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Sends texts to one front, one after the other; a slow front makes nobody wait. Rows go out only while nothing else is unsent, so that a slow front gets
 * the newest ones. From any thread.
 */
final class Outbox {
    static final int MOST_REPLIES = 256;

    /** Where texts go. */
    interface Line {
        /** Sends a text; {@code sent} is run when it has gone out, or never. */
        void send(String text, Runnable sent);
    }

    private final Line line;
    private final Deque<String> waiting = new ArrayDeque<>();
    private boolean busy;

    Outbox(Line line) {
        this.line = line;
    }

    /** Whether rows may be sent now. */
    synchronized boolean isIdle() {
        return !busy && waiting.isEmpty();
    }

    /** Sends a text after all before it; refuses where too many wait. */
    boolean offer(String text) {
        synchronized (this) {
            if (busy) {
                if (waiting.size() >= MOST_REPLIES) {
                    return false;
                }
                waiting.add(text);
                return true;
            }
            busy = true;
        }
        line.send(text, this::sent);
        return true;
    }

    private void sent() {
        String next;
        synchronized (this) {
            next = waiting.poll();
            if (next == null) {
                busy = false;
                return;
            }
        }
        line.send(next, this::sent);
    }
}
