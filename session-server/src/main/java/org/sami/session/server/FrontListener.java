package org.sami.session.server;

/** Receives what happens to one connection of a front. Called on Jetty's threads; returns at once. */
interface FrontListener {
    /** It can be sent to. */
    void opened();

    /** A message that is well formed. */
    void received(FrontMessage message);

    /** It has ended, once. */
    void closed();
}
