package org.sami.crw.proxy.gateway;

import java.net.InetSocketAddress;
import java.util.List;
import org.sami.spn.protocol.Priority;

/** A link, or an attempt at one, to a vehicle for which the gateway speaks the boat link. Safe for use by several threads. */
public interface GatewayLink {

    /** Receives the events of a link, on a thread of the gateway. */
    interface Listener {
        /** The vehicle is heard: the base may say hello. */
        void opened();

        /** A whole frame of the boat link. */
        void arrived(byte[] frame);

        /** A message about the vehicle for the operator. */
        void said(Priority priority, String text);

        /** The vehicle could not be reached, or the link has ended, for a reason in words. Called once; nothing follows. */
        void closed(String why);

        /** In place of {@link #closed}: something answers that is not commanded from here, or not as it is set. */
        default void refused(String why) {
            closed(why);
        }

        /**
         * The address leads to a vehicle that has this address: it stands for several, or is a second link to one that is reached at another. Called for
         * each.
         */
        void found(InetSocketAddress vehicle);
    }

    /** Takes a whole frame of the boat link; one that comes before the link is open is lost. */
    void send(byte[] frame);

    /** The links on which the vehicle is reached now, the one in use first; empty where that is not known, or no matter. */
    default List<LinkStatus> linkStatuses() {
        return List.of();
    }

    /** Ends it. */
    void close();
}
