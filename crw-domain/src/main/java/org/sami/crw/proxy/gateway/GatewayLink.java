package org.sami.crw.proxy.gateway;

import java.net.InetSocketAddress;
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

        /** The address stands for several vehicles; this is the address of one of them. Called for each. */
        void found(InetSocketAddress vehicle);
    }

    /** Takes a whole frame of the boat link; one that comes before the link is open is lost. */
    void send(byte[] frame);

    /** Ends it. */
    void close();
}
