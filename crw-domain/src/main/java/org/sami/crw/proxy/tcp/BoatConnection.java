package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.security.Fingerprint;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.spn.protocol.Priority;

/** One connection to a boat, from the try to connect to its end. Frames that are sent never make the sender wait. */
interface BoatConnection extends FrameSink {

    /** Where a connection hands what happens; called on threads of the connection. */
    interface Owner {
        /** It stands. */
        void opened(BoatConnection connection);

        /** A whole frame has come; {@code done} is to be run once it has been taken. */
        void arrived(BoatConnection from, byte[] frame, Runnable done);

        /** It is closed or could not be had, for a reason in words. Called once. */
        void closed(BoatConnection connection, String why);

        /** In place of {@link #closed}: what answers there was refused. */
        void refused(BoatConnection connection, String why);

        /** The address is one of several boats; this is the address of one of them. */
        void found(InetSocketAddress boat);

        /** What answers says this to the operator. */
        void said(Priority priority, String text);
    }

    /** Begins to connect. */
    void start();

    /** The boat's key; empty while there is no link, and on a plain one. */
    Optional<Fingerprint> peer();

    /** How many frames were left out, as too many came, since this was asked last. */
    long takeLeftOut();

    /** The links on which the boat is reached; empty where it has this connection alone. */
    default List<LinkStatus> linkStatuses() {
        return List.of();
    }

    /** Ends it, for a reason in words. */
    void close(String why);

    /** Waits until the threads of this connection have ended, after {@link #close}; not for these threads themselves. */
    void join(long millis) throws InterruptedException;
}
