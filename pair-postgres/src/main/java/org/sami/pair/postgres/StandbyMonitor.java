package org.sami.pair.postgres;

import java.sql.Connection;
import java.sql.SQLException;
import java.time.Clock;
import java.time.LocalTime;
import java.time.temporal.ChronoUnit;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.journal.postgres.Connections;
import org.sami.journal.postgres.DatabaseFaults;

/**
 * Looks, beside a session that holds its pair, whether the standby follows, and has the database wait for it or go on without it. Looks twice a second on a thread of its own, by a connection
 * of its own.
 */
public final class StandbyMonitor implements AutoCloseable {
    private static final long LOOK_MILLIS = 500;

    private final PairConnections connections;
    private final PairSettings settings;
    private final Clock clock;
    private final Consumer<String> lines;
    private final ScheduledExecutorService thread;
    private @Nullable Future<?> looks;
    private @Nullable Connection connection;
    private String said = "";

    private StandbyMonitor(PairConnections connections, PairSettings settings, Clock clock, Consumer<String> lines) {
        this.connections = connections;
        this.settings = settings;
        this.clock = clock;
        this.lines = lines;
        thread = Executors.newSingleThreadScheduledExecutor(work -> {
            Thread made = new Thread(work, "standby of " + settings.here());
            made.setDaemon(true);
            return made;
        });
    }

    /**
     * One that looks from now on.
     *
     * @param clock says since when, for people
     * @param lines what becomes of the pair, for people, on the monitor's thread; each line once in a row
     */
    public static StandbyMonitor start(PairFolder folder, Clock clock, Consumer<String> lines) throws PairException {
        PairSettings settings = folder.settings();
        StandbyMonitor monitor = new StandbyMonitor(new PairConnections(folder, settings), settings, clock, lines);
        monitor.looks = monitor.thread.scheduleWithFixedDelay(monitor::look, 0, LOOK_MILLIS, TimeUnit.MILLISECONDS);
        return monitor;
    }

    private void look() {
        try {
            Connection used = connection;
            if (used == null) {
                used = connections.own();
                connection = used;
            }
            look(used);
        } catch (SQLException fault) {
            say("pair: this base's database does not answer: " + DatabaseFaults.words(fault));
            drop();
        } catch (RuntimeException fault) {
            System.getLogger(StandbyMonitor.class.getName())
                    .log(System.Logger.Level.ERROR, "looking at the standby of a pair", fault);
            drop();
        }
    }

    private void look(Connection used) throws SQLException {
        boolean waits = Replication.waitsForStandby(used);
        StandbyLook look = Replication.standby(used);
        switch (PairRule.next(settings.whenCut(), waits, look)) {
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
        say(words(waits, look));
    }

    private String words(boolean waits, StandbyLook look) {
        if (!waits) {
            String why = look.hasEnded()
                    ? "the standby was ended"
                    : look.isConnected() ? "the standby is catching up" : "no standby";
            return "pair: alone, " + why + ": what this base writes is on this machine only";
        }
        if (look.isConnected()) {
            return "pair: protected, " + settings.other() + " has all that is confirmed";
        }
        return "pair: nothing comes from " + settings.other()
                + ", which may go on with the session: this base stops commanding until it answers. Once "
                + settings.other()
                + " is off, here: crw pair alone";
    }

    private void say(String line) {
        if (!line.equals(said)) {
            said = line;
            lines.accept(line + ", since " + LocalTime.now(clock).truncatedTo(ChronoUnit.SECONDS));
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
            if (!thread.awaitTermination(LOOK_MILLIS * 10, TimeUnit.MILLISECONDS)) {
                return; // its connection answers within seconds, or is dropped by it
            }
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return;
        }
        drop();
    }
}
