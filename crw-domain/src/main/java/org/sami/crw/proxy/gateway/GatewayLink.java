package org.sami.crw.proxy.gateway;

import java.net.InetSocketAddress;

/** A try to reach one vehicle, and what comes of it. */
public interface GatewayLink {

    /** What a link tells; on a thread of the gateway. */
    interface Listener {
        /** The vehicle is heard; it is now said hello to. */
        void opened();

        /** A whole frame of the boat link. */
        void arrived(byte[] frame);

        /** The operator must know this of it. */
        void alarm(String text);

        /** It could not be reached or is reached no longer, for a reason in words. Told once; nothing follows. */
        void closed(String why);

        /** The address is one of several vehicles; this is the address of one of them. Told of each. */
        void found(InetSocketAddress vehicle);
    }

    /** Takes a whole frame of the boat link; one that comes before the link is open is lost. */
    void send(byte[] frame);

    /** Ends it. */
    void close();
}
