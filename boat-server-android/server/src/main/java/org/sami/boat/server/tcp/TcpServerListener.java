package org.sami.boat.server.tcp;

/**
 * Gets to know of a boat's connections, for its console. Called on any thread of the server, quickly and without throwing.
 */
public interface TcpServerListener {
    /** Tells nobody. */
    TcpServerListener NONE = new TcpServerListener() {};

    /** A client has connected; it has said nothing yet. */
    default void connected(String client) {}

    /** A client has gone or was dropped, for a reason in words. */
    default void closed(String client, String why) {}

    /** Something broke; the server goes on. */
    default void failed(String what, Throwable cause) {}

    /** What had failed works again. */
    default void recovered(String what) {}
}
