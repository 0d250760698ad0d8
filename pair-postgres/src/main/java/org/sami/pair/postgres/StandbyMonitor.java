package org.sami.pair.postgres;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.SQLException;
import java.time.Clock;
import java.time.LocalTime;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.DatabaseFaults;

/**
 * Looks, beside a session that holds its pair, whether the standby follows, and has the database wait for it or go on without it. Looks four times a second on a thread of its own, by a connection
 * of its own.
 */
public final class StandbyMonitor implements AutoCloseable {
    private static final long LOOK_MILLIS = 250;
    private static final long ASK_MILLIS = 2000;

    private final PairConnections connections;
    private final String session;
    private final WhenCut whenCut;
    private final Clock clock;
    private final Path log;
    private final BiConsumer<Protection, LocalTime> listener;
    private final ScheduledExecutorService thread;
    private @Nullable Future<?> looks;
    private @Nullable Connection connection;
    private @Nullable Protection said;
    private long askedMillis;
    private boolean replaced;

    private StandbyMonitor(PairFolder folder, String session, Clock clock, BiConsumer<Protection, LocalTime> listener)
            throws PairException {
        this.session = session;
        PairSettings settings = folder.settings();
        this.whenCut = settings.whenCut();
        this.connections = new PairConnections(folder, settings);
        this.log = folder.log();
        this.clock = clock;
        this.listener = listener;
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, "standby of " + settings.here());
            made.setDaemon(true);
            return made;
        });
    }

    /**
     * One that looks from now on.
     *
     * @param session its name
     * @param clock says since when, for people
     * @param listener told what becomes of the protection, and since when, on the monitor's thread
     */
    public static StandbyMonitor start(
            PairFolder folder, String session, Clock clock, BiConsumer<Protection, LocalTime> listener)
            throws PairException {
        StandbyMonitor monitor = new StandbyMonitor(folder, session, clock, listener);
        monitor.looks = monitor.thread.scheduleWithFixedDelay(monitor::look, 0, LOOK_MILLIS, TimeUnit.MILLISECONDS);
        return monitor;
    }

    private void look() {
        try {
            Connection used = connection;
            if (used == null) {
                used = connections.own();
                connection = used;
                StandbySign.completeTable(used);
            }
            look(used);
        } catch (SQLException fault) {
            say(new Protection(
                    Protection.State.UNKNOWN,
                    "this base's database does not answer: " + DatabaseFaults.words(fault),
                    "It is started again by the next 'crw serve --pair'; " + log + " says why it ended"));
            drop();
        } catch (RuntimeException fault) {
            System.getLogger(StandbyMonitor.class.getName())
                    .log(System.Logger.Level.ERROR, "looking at the standby of a pair", fault);
            drop();
        }
    }

    private void look(Connection used) throws SQLException {
        if (replaced) {
            return; // for good
        }
        boolean waits = Replication.waitsForStandby(used);
        StandbyState look = Replication.standby(used, session);
        switch (PairRule.next(whenCut, waits, look)) {
            case PROTECT -> {
                Replication.setWaitsForStandby(used, true);
                waits = true;
            }
            case GO_ALONE -> {
                Replication.setWaitsForStandby(used, false);
                waits = false;
            }
            case NONE -> {}
        }
        say(protection(
                waits, look)); // before the other base is asked, which may take seconds where nothing comes from it
        if (!look.isConnected() && otherWentOn(Replication.timeline(used))) {
            replaced = true;
            say(new Protection(
                    Protection.State.REPLACED,
                    other() + " took the session over: this base ends with it",
                    "This base comes back as the standby by 'crw pair rejoin'"));
        }
    }

    /** Asks the other base, where it answers, at most every two seconds. */
    private boolean otherWentOn(int timeline) {
        long now = clock.millis();
        if (now >= askedMillis && now - askedMillis < ASK_MILLIS) {
            return false;
        }
        askedMillis = now;
        try (Connection other = connections.other()) {
            return !Replication.isReplica(other) && Replication.timeline(other) > timeline;
        } catch (SQLException silent) {
            return false;
        }
    }

    private Protection protection(boolean waits, StandbyState look) {
        if (!waits) {
            String why = look.hasEnded()
                    ? "the standby was ended"
                    : look.isConnected() ? "the standby is catching up" : "no standby answers";
            return new Protection(
                    Protection.State.ALONE,
                    "alone, " + why + ": what this base writes is on this machine only",
                    "Once 'crw serve --pair' runs on " + other() + ", the session is protected again");
        }
        if (look.isConnected() && !look.isWatched()) {
            return new Protection(
                    Protection.State.COPIED,
                    "copied: " + other() + " has all that is confirmed, but nobody waits there to go on with it",
                    "On " + other() + ": crw serve --pair");
        }
        if (look.isConnected()) {
            return new Protection(
                    Protection.State.PROTECTED, "protected: " + other() + " has all that is confirmed", "");
        }
        return new Protection(
                Protection.State.SILENT,
                "nothing comes from " + other()
                        + ", which may go on with the session: this base stops commanding until it answers",
                "If " + other() + " is off, here: crw pair alone; if it has another address: crw pair address");
    }

    private String other() {
        return connections.settings().other();
    }

    private void say(Protection now) {
        if (!now.equals(said)) {
            said = now;
            listener.accept(now, LocalTime.now(clock));
        }
    }

    private void drop() {
        Connection used = connection;
        connection = null;
        if (used != null) {
            Connections.drop(used);
        }
    }

    @Override
    public void close() {
        if (looks != null) {
            looks.cancel(false);
        }
        thread.shutdown();
        try {
            if (!thread.awaitTermination(LOOK_MILLIS * 20, TimeUnit.MILLISECONDS)) {
                return; // its connection answers within seconds, or is dropped by it
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return;
        }
        drop();
    }
}
