package org.sami.crw.proxy.tcp;

import java.net.InetSocketAddress;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.link.LinkAlarm;

/** Gets to know what becomes of a base's links. Called on the base's thread. */
public interface BaseListener {

    /** A boat with a new id has answered; gives the listener of its proxy. */
    Consumer<FleetEvent> found(String boatId);

    /** The proxy of a boat that was found is there, and can be given commands. */
    default void onBoat(BoatProxy proxy) {}

    /** A boat is reached at an address from now on: at its first one, or again. */
    default void onReached(String boatId, InetSocketAddress at) {}

    /** A boat is reached at another address from now on. */
    default void onMoved(String boatId, InetSocketAddress from, InetSocketAddress to) {}

    /** What is reached at an address is the vehicle at another one, over a second link: it is one boat, with the other address. */
    default void onJoined(InetSocketAddress joined, InetSocketAddress vehicle) {}

    /** A boat has been removed; its proxy is no longer among the boats of the base. */
    default void onRemoved(String boatId) {}

    /** An operator must know this. Told once for each boat and address, until the boat is found elsewhere or is removed. */
    default void onAlarm(LinkAlarm alarm) {}

    /** Something broke, such as a listener that threw; the links go on. */
    default void onFailure(String what, RuntimeException cause) {}
}
