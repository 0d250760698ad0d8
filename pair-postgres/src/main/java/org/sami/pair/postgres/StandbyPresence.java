package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;

/** Reports to the base that holds a session that this base is its standby: again and again, since the holder may not be there yet, and at the end that it is none any longer. */
public final class StandbyPresence implements AutoCloseable {
    private static final long SAY_MILLIS = 2000;

    private final PairConnections connections;
    private final String session;
    private final ScheduledExecutorService thread;
    private final Future<?> saying;

    StandbyPresence(PairConnections connections, String session) {
        this.connections = connections;
        this.session = session;
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, "presence of a standby");
            made.setDaemon(true);
            return made;
        });
        saying = thread.scheduleWithFixedDelay(() -> say(false), 0, SAY_MILLIS, TimeUnit.MILLISECONDS);
    }

    /** Reports that this standby ends in order and will not go on with the session: the holder need not wait for it. False where the holder is not reached. */
    public boolean leave() {
        close();
        awaitEnd(); // what it says last is to count
        return say(true);
    }

    private boolean say(boolean ended) {
        try (Connection other = connections.other()) {
            StandbySign.completeTable(other);
            if (ended) {
                StandbySign.writeEnd(other, session);
            } else {
                StandbySign.writePresence(other, session);
            }
            return true;
        } catch (SQLException silent) {
            return false; // whoever looks at the pair sees that the bases do not reach one another
        }
    }

    /** Ends the reports. Does not wait for a report under way, which may be to a base that does not answer. */
    @Override
    public void close() {
        saying.cancel(false);
        thread.shutdown();
    }

    private void awaitEnd() {
        try {
            if (!thread.awaitTermination(SAY_MILLIS * 2, TimeUnit.MILLISECONDS)) {
                thread.shutdownNow();
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
