package org.sami.pair.postgres;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.sql.Connection;
import java.sql.SQLException;
import java.util.concurrent.TimeUnit;
import org.sami.journal.postgres.DatabaseFaults;

/**
 * Gives the bases of a pair other addresses, as in another network. Each base is told on its own: it lets the other in from there, looks for it there and follows it there from what it has on, so that
 * nothing is copied anew. The certificate of a pair names no machine, and stays. For one thread.
 */
public final class PairMove {
    private static final int ANSWER_MILLIS = 1000;
    private static final int LOOKS = 40;
    private static final long LOOK_MILLIS = 250;

    /** Databases of a pair notice after 2 s that nothing comes. */
    private static final int LOOKS_AT_LOST = 12;

    private static final String LOGIN_REFUSED = "28"; // how SQL states of refused logins begin

    private final PairFolder folder;
    private final PairSettings before;
    private final PairSettings after;
    private final PairConnections connections;

    /** How the bases stand after a change. */
    public enum Link {
        /** One of both follows the other. */
        CONNECTED,
        /** The other base lets this one in, and does not know its address yet, or does not follow for another reason. */
        ANSWERS,
        /** The other base took the session over from this one. */
        REPLACED_HERE,
        /** This base took the session over from the other. */
        REPLACED_THERE,
        /** The other base does not let this one in from its new address. */
        REFUSED,
        /** No database of this pair answers there. */
        SILENT
    }

    /**
     * What has been changed.
     *
     * @param hasRestarted whether this base's database was away for a moment, as it listens at another address now
     */
    public record Change(PairSettings before, PairSettings after, boolean hasRestarted, Link link) {}

    private PairMove(PairFolder folder, PairSettings before, PairSettings after) {
        this.folder = folder;
        this.before = before;
        this.after = after;
        connections = new PairConnections(folder, after);
    }

    /**
     * Changes the addresses as this base sees them. A base that serves the pair's session meanwhile follows by itself; the same call again completes one that was interrupted.
     *
     * @param here address or name of this base, as the other reaches it
     * @param other address or name of the other base
     * @throws PairException if that cannot be, or would cut bases that are connected; nothing was changed then
     * @throws IllegalArgumentException in words, if one is no address
     */
    public static Change to(PairFolder folder, String here, String other) throws IOException {
        PairSettings before = folder.settings();
        PairMove move = new PairMove(folder, before, before.at(here, other));
        move.checkIsHere();
        Programs programs = Programs.of(folder);
        PairDatabase database = new PairDatabase(folder, programs, move.after);
        boolean wasRunning = database.isRunning();
        if (wasRunning) {
            move.checkDoesNotCut();
        }
        move.write(move.after);
        boolean restarted;
        try {
            restarted = move.listen(database);
        } catch (PairException fault) {
            throw move.undone(new PairDatabase(folder, programs, before), wasRunning, fault);
        }
        move.follow();
        return new Change(before, move.after, restarted, move.link());
    }

    private void write(PairSettings settings) throws IOException {
        new AccessList(folder.data()).replace(settings);
        folder.replace(settings);
    }

    /** Has the base at its earlier addresses again, as its database does not start at the new one. */
    private PairException undone(PairDatabase database, boolean wasRunning, PairException fault) throws IOException {
        write(before);
        try {
            if (wasRunning && !database.isRunning()) {
                database.start();
            }
        } catch (PairException silent) {
            fault.addSuppressed(silent);
            return new PairException(
                    fault.getMessage() + "; the addresses are as before, and it does not start with them either",
                    fault);
        }
        return new PairException(fault.getMessage() + "; nothing was changed", fault);
    }

    /** A database that listens nowhere does not start. */
    private void checkIsHere() throws PairException {
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getByName(after.here()))) {
            assert free.isBound();
        } catch (IOException elsewhere) {
            throw new PairException(
                    after.here() + " is no address of this machine (" + elsewhere.getMessage()
                            + "): --here names it; nothing was changed",
                    elsewhere);
        }
    }

    /** A mistyped address would end the protection of a session; a replica finds a database that went elsewhere no longer. */
    private void checkDoesNotCut() throws IOException {
        boolean leavesReplica = !after.here().equals(before.here());
        boolean nobodyThere = !after.other().equals(before.other()) && look() == Link.SILENT;
        if (!leavesReplica && !nobodyThere) {
            return;
        }
        boolean isReplica;
        try (Connection own = new PairConnections(folder, before).own()) {
            isReplica = Replication.isReplica(own);
            if ((isReplica && !nobodyThere) || !staysConnected(own)) {
                return;
            }
        } catch (SQLException silent) {
            return; // it is restarted
        }
        if (leavesReplica && !isReplica) {
            throw new PairException(before.other() + " follows the database of this base at " + before.here()
                    + ", where it would be no longer; nothing was changed. First, there: end crw serve, then crw pair"
                    + " stop. Then give this command again, and then, there: crw pair address " + after.here());
        }
        throw new PairException("the bases are connected by " + before.other() + ", and no database of this pair"
                + " answers at " + after.other() + "; nothing was changed. If the other base has that address: "
                + "there first, crw pair address " + after.here());
    }

    /** Whether the bases are connected, and not only because a network that was left a moment ago is not missed yet. */
    private static boolean staysConnected(Connection own) throws SQLException, InterruptedIOException {
        for (int look = 0; look < LOOKS_AT_LOST; look++) {
            if (!isConnected(own)) {
                return false;
            }
            pause();
        }
        return isConnected(own);
    }

    private static void pause() throws InterruptedIOException {
        try {
            TimeUnit.MILLISECONDS.sleep(LOOK_MILLIS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted while waiting for the other base of a pair");
        }
    }

    private static boolean isConnected(Connection own) throws SQLException {
        return Replication.isReplica(own)
                ? Replication.isFollowing(own)
                : Replication.replica(own).isConnected();
    }

    /** Listens at the present address, and has read who may connect; whether it was restarted for that. */
    private boolean listen(PairDatabase database) throws IOException {
        if (!database.isRunning()) {
            database.start();
            return false;
        }
        if (answersHere()) {
            database.reload();
            return false;
        }
        database.stop();
        database.start();
        return true;
    }

    /** It does not either where it was started before the machine had the address. */
    private boolean answersHere() {
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(after.here(), after.port()), ANSWER_MILLIS);
            return true;
        } catch (IOException silent) {
            return false;
        }
    }

    private void follow() throws PairException {
        try (Connection admin = connections.asAdmin("postgres")) {
            if (Replication.isReplica(admin)) {
                Replication.follow(admin, connections.sourceOfReplica());
            }
        } catch (SQLException fault) {
            throw new PairException(
                    "the database of this base: " + DatabaseFaults.words(fault)
                            + "; the addresses were changed: give the same command again",
                    fault);
        }
    }

    /** Waits a little for the bases to find one another. */
    private Link link() throws IOException {
        Link link = look();
        for (int look = 0; look < LOOKS && link == Link.ANSWERS; look++) {
            try (Connection own = connections.own()) {
                if (isConnected(own)) {
                    return Link.CONNECTED;
                }
                if (!Replication.isReplica(own)) {
                    link = replaced(Replication.timeline(own));
                }
                pause();
            } catch (SQLException fault) {
                throw new PairException("the database of this base: " + DatabaseFaults.words(fault), fault);
            }
        }
        return link;
    }

    /** Whether one of both databases is there no longer as the other's replica. */
    private Link replaced(int timeline) {
        try (Connection other = connections.other()) {
            if (Replication.isReplica(other)) {
                return Link.ANSWERS;
            }
            return Replication.timeline(other) > timeline ? Link.REPLACED_HERE : Link.REPLACED_THERE;
        } catch (SQLException silent) {
            return Link.ANSWERS; // it did a moment ago
        }
    }

    private Link look() {
        try (Connection other = connections.other(after)) {
            return other.isValid(ANSWER_MILLIS / 1000) ? Link.ANSWERS : Link.SILENT;
        } catch (SQLException fault) {
            String state = fault.getSQLState();
            return state != null && state.startsWith(LOGIN_REFUSED) ? Link.REFUSED : Link.SILENT;
        }
    }
}
