package org.sami.crw.proxy.tcp;

import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatProxy;

/** Gets to know what becomes of a base's links. Called on the base's thread. */
public interface BaseListener {

    /** A boat with a new id has answered; gives the listener of its proxy. */
    BoatListener found(String boatId);

    /** The proxy of a boat that was found is there, and can be given commands. */
    default void onBoat(BoatProxy proxy) {}

    /** An operator must know this. Told once for each boat, start of its server, and address. */
    default void onAlarm(LinkAlarm alarm) {}

    /** Something broke, such as a listener that threw; the links go on. */
    default void onFailure(String what, RuntimeException cause) {}
}
