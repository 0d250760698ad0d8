package org.sami.pair.postgres;

import java.io.IOException;
import java.sql.Connection;
import java.sql.SQLException;
import java.time.Clock;
import java.time.LocalTime;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.sami.journal.postgres.DatabaseFaults;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.journal.postgres.TakeOver;

/** This base as one of a pair: what it is at present, and what a person asks of it. Each call asks databases, some of another machine: for no event thread. */
public final class BasePair {
    private static final int PROMOTION_SECONDS = 30;

    private final PairFolder folder;
    private final PairSettings settings;
    private final PairConnections connections;

    /** What this base's database is. */
    public enum Part {
        /** The session is written here. */
        DATABASE,
        /** It follows the other base's. */
        REPLICA
    }

    private BasePair(PairFolder folder, PairSettings settings) {
        this.folder = folder;
        this.settings = settings;
        this.connections = new PairConnections(folder, settings);
    }

    /**
     * The pair of a folder; its database of this base is started where it does not run.
     *
     * @throws PairException if there is no pair, or the database does not start
     */
    public static BasePair open(PairFolder folder) throws IOException {
        BasePair pair = new BasePair(folder, folder.settings());
        PairDatabase database = PairDatabase.of(folder);
        if (!database.isRunning()) {
            database.start();
        }
        return pair;
    }

    /** How this base sees it. */
    public PairSettings settings() {
        return settings;
    }

    /** Where the journal of a session is: a name for each. */
    public PostgresAddress journal(String name) {
        return connections.journal(name);
    }

    /** What this base's database is. */
    public Part part() throws PairException {
        return own(connection -> Replication.isReplica(connection) ? Part.REPLICA : Part.DATABASE);
    }

    /**
     * What this base does in the pair at present.
     *
     * @param name of the session
     * @throws SilentBaseException if the other base does not answer, and may have gone on with the session
     * @throws PairException if this base must not hold a session, as the other went on with it
     */
    public Part checkedPart(String name) throws PairException {
        if (part() == Part.REPLICA) {
            return Part.REPLICA;
        }
        int timeline = own(Replication::timeline);
        boolean waits = own(Replication::waitsForStandby);
        try (Connection other = connections.other()) {
            if (!Replication.isReplica(other) && Replication.timeline(other) > timeline) {
                throw new PairException(settings.other()
                        + " took the session over: this base comes back as its standby by 'crw pair rejoin'");
            }
        } catch (SQLException silent) {
            if (waits && settings.whenCut() == WhenCut.TAKE_OVER) {
                throw new SilentBaseException(settings.other() + " does not answer (" + DatabaseFaults.words(silent)
                        + ") and may have gone on with the session");
            }
            if (isLeft(name)) {
                throw new PairException(settings.other() + " does not answer (" + DatabaseFaults.words(silent)
                        + ") and may go on with the session, as the database of this base no longer follows it: both"
                        + " would command. If it is off: crw take-over --confirm");
            }
        }
        return Part.DATABASE;
    }

    /** How this base and the other stand, for people: a line each. */
    public String standing() throws PairException {
        StringBuilder text = new StringBuilder();
        text.append("when cut: ")
                .append(
                        settings.whenCut() == WhenCut.TAKE_OVER
                                ? "the standby goes on by itself, and the other base stops before that"
                                : "the base that has the session goes on, the standby only by 'crw take-over'")
                .append(System.lineSeparator());
        text.append("this base, ").append(settings.here()).append(": ").append(this.<String>own(BasePair::standing));
        text.append(System.lineSeparator())
                .append("the other, ")
                .append(settings.other())
                .append(": ");
        try (Connection other = connections.other()) {
            text.append(standing(other));
        } catch (SQLException silent) {
            text.append("does not answer: ").append(DatabaseFaults.words(silent));
        }
        return text.toString();
    }

    private static String standing(Connection connection) throws SQLException {
        if (Replication.isReplica(connection)) {
            return Replication.lastReceived(connection)
                    .map(time -> "replica, the last it received at " + time)
                    .orElse("replica, which has received nothing yet");
        }
        String sessions = StandbySign.sessions(connection);
        ReplicaState replica = Replication.replica(connection);
        String standby = !replica.isConnected()
                ? "no standby answers"
                : replica.isStreaming()
                        ? "its standby follows, " + replica.behindBytes() + " bytes behind"
                                + (sessions.isEmpty()
                                        ? ", but no 'crw serve --pair' waits there"
                                        : ", and waits for " + sessions)
                        : "its standby catches up";
        return "database of the session, " + (Replication.waitsForStandby(connection) ? "protected: " : "alone: ")
                + standby;
    }

    /**
     * Has this base go on without its standby, at the word of a person who knows that the other does not go on.
     *
     * @throws PairException if this base is the standby
     */
    public void goAlone() throws PairException {
        if (part() == Part.REPLICA) {
            throw new PairException(
                    "this base is the standby: it goes on with the session by itself, or by 'crw take-over'");
        }
        own(connection -> {
            StandbySign.writeEndOfAll(connection); // it is waited for again once it says that it is there
            Replication.setWaitsForStandby(connection, false);
            return true;
        });
    }

    /**
     * Whether this base may follow the other one's database anew.
     *
     * @throws PairException if there is none to follow, or the session is here
     */
    public void checkRejoin() throws PairException {
        boolean replica = part() == Part.REPLICA;
        int timeline = replica ? 0 : own(Replication::timeline);
        try (Connection other = connections.other()) {
            if (Replication.isReplica(other)) {
                throw new PairException(
                        settings.other() + " is a replica: there is nothing to follow; nothing was changed");
            }
            if (!replica && Replication.timeline(other) <= timeline) {
                throw new PairException("this base has the session, not " + settings.other() + "; nothing was changed");
            }
        } catch (SQLException silent) {
            throw new PairException(
                    settings.other() + " does not answer: " + DatabaseFaults.words(silent) + "; nothing was changed",
                    silent);
        }
    }

    /** Says to the base that has a session that this one stands by for it, until it is closed. */
    public StandbyPresence standBy(String session) {
        return new StandbyPresence(connections, session);
    }

    /**
     * Looks after the standby while this base holds a session.
     *
     * @param session its name
     * @param clock says since when, in the time zone of people
     * @param listener told what becomes of the protection, and since when, on the monitor's thread
     */
    public StandbyMonitor monitor(String session, Clock clock, BiConsumer<Protection, LocalTime> listener)
            throws PairException {
        return StandbyMonitor.start(folder, session, clock, listener);
    }

    /**
     * What a take-over at a person's word would lose, for people; empty where nothing is lost, as the other base answers and gives the session away in order.
     *
     * @param name of the session
     * @throws PairException if this base has the session
     */
    public Optional<String> lossOfTakeOver(String name) throws PairException {
        if (part() == Part.DATABASE) {
            checkLeft(name);
            return Optional.of("The database of this base no longer follows that of " + settings.other()
                    + ": if the other goes on with the session, both command; what it wrote alone after that is lost");
        }
        try (Connection other = connections.other()) {
            if (!Replication.isReplica(other)) {
                return Optional.empty();
            }
        } catch (SQLException silent) {
            // it is off, or cut
        }
        String last = own(Replication::lastReceived)
                .map(time -> "This base received the last of it at " + time)
                .orElse("This base has received nothing of it yet");
        return Optional.of(
                settings.other() + " does not answer. " + last + "; what the other wrote alone after that is lost");
    }

    /**
     * Takes the session over at a person's word: from the other base where it answers, else as far as this base has it. The base here that waits for it goes on with it then.
     *
     * @param name of the session
     * @param lossConfirmed whether a person has confirmed what {@link #lossOfTakeOver} says: only then it is taken from a base that does not answer
     * @return who held it, for people; empty where nobody did
     */
    public Optional<String> takeOver(String name, boolean lossConfirmed) throws PairException {
        if (part() == Part.DATABASE) {
            checkLeft(name);
            if (!lossConfirmed) {
                throw new PairException("the database of this base no longer follows that of " + settings.other()
                        + "; nothing was taken over");
            }
            return takeHere(name);
        }
        try (Connection other = connections.other()) {
            if (!Replication.isReplica(other)) {
                if (!Replication.replica(other).isStreaming()) {
                    throw new PairException("this base does not follow " + settings.other()
                            + " at present: nothing was taken over; if it cannot catch up: crw pair rejoin");
                }
                return TakeOver.takeAway(connections.otherJournal(name));
            }
        } catch (SQLException fault) {
            if (!lossConfirmed) {
                throw new PairException(
                        settings.other() + ": " + DatabaseFaults.words(fault) + "; nothing was taken over", fault);
            }
        }
        return takeHere(name);
    }

    private Optional<String> takeHere(String name) throws PairException {
        try (Connection patient = connections.own(PROMOTION_SECONDS)) {
            if (Replication.isReplica(patient)) {
                Replication.promote(patient, PROMOTION_SECONDS);
            }
            return TakeOver.takeFromOtherDatabase(connections.journal(name));
        } catch (SQLException fault) {
            throw new PairException("the database of this base: " + DatabaseFaults.words(fault), fault);
        }
    }

    /** Whether this base's replica was promoted by other means than this program, and nobody has gone on with the session here since. */
    private boolean isLeft(String name) throws PairException {
        return this.<Boolean>own(connection -> TakeOver.isLeftByOtherDatabase(connections.journal(name)));
    }

    private void checkLeft(String name) throws PairException {
        if (!isLeft(name)) {
            throw new PairException("this base has the session's database: nothing is to be taken over here");
        }
    }

    private <T> T own(Asking<T> asking) throws PairException {
        try (Connection connection = connections.own()) {
            return asking.ask(connection);
        } catch (SQLException fault) {
            throw new PairException("the database of this base: " + DatabaseFaults.words(fault), fault);
        }
    }

    @FunctionalInterface
    private interface Asking<T> {
        T ask(Connection connection) throws SQLException;
    }
}
