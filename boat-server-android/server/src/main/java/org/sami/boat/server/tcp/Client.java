package org.sami.boat.server.tcp;

import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.server.BoatKeys;
import org.sami.boat.server.ServerSession;

/** What the boat's thread knows of a connection. */
final class Client {
    private static final long LAST_MESSAGE_WITHIN_MS = 1000;

    private final ClientConnection connection;
    private final ServerSession session;
    private final long sinceMs;
    private long greetedMs = Long.MAX_VALUE;
    private long leavingMs = Long.MAX_VALUE;
    private long ticksSinceFrame;

    Client(ClientConnection connection, ServerSession session, long nowMs) {
        this.connection = connection;
        this.session = session;
        sinceMs = nowMs;
    }

    ClientConnection connection() {
        return connection;
    }

    /** The link is protected, and that is the client's key. */
    void protectedBy(BoatKeys keys, Fingerprint key) {
        session.protectedBy(keys, key);
    }

    /** Takes a frame from the client. */
    void receive(byte[] frame, long nowMs) {
        long refused = session.refusedFrames();
        session.receive(frame, nowMs);
        if (session.refusedFrames() == refused) {
            ticksSinceFrame = 0;
        }
        if (session.role().isPresent()) {
            greetedMs = Math.min(greetedMs, nowMs);
        }
    }

    /** Lets a tick of the boat pass; returns how many have passed since something came that could be read. */
    long tick() {
        return ++ticksSinceFrame;
    }

    /** The link has closed. */
    void closed(long nowMs) {
        session.closed(nowMs);
    }

    /** Whether its greeting is overdue. */
    boolean isOverdue(long nowMs, long helloWithinMs) {
        return !isGreeted() && nowMs - sinceMs > helloWithinMs;
    }

    /** Whether it has greeted. */
    boolean isGreeted() {
        return session.role().isPresent();
    }

    /** Whether its greeting is at least this long ago. */
    boolean isGreetedFor(long nowMs, long millis) {
        return isGreeted() && nowMs - greetedMs >= millis;
    }

    /** Whether it commands the boat and is heard. */
    boolean commands() {
        return session.role().filter(role -> role == Role.COMMANDER).isPresent();
    }

    /** Whether it has asked to command. */
    boolean wishesToCommand() {
        return session.wishesToCommand();
    }

    /** For how long nothing that can be read has come from it, in ms. */
    long silentForMs(long nowMs) {
        return session.silentForMs(nowMs);
    }

    /** Whether it has been dismissed. */
    boolean isLeaving() {
        return session.dismissal().isPresent();
    }

    /** Whether it has been dismissed because of its key. */
    boolean isRefusedForItsKey() {
        return isLeaving() && session.isStranger();
    }

    /** Dismisses it; the goodbye leaves before the connection is closed. */
    void turnAway(String reason, long nowMs) {
        session.turnAway(reason, nowMs);
    }

    /** Closes the connection of a dismissed client once its last message has left, or does not leave for long. */
    void closeIfLeaving(long nowMs) {
        session.dismissal().ifPresent(why -> {
            leavingMs = Math.min(leavingMs, nowMs);
            if (nowMs - leavingMs < LAST_MESSAGE_WITHIN_MS) {
                connection.closeOnceSent(why);
            } else {
                connection.close(why);
            }
        });
    }
}
