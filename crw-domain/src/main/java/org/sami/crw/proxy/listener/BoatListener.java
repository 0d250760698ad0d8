package org.sami.crw.proxy.listener;

import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.LeftOut;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.value.GeoPoint;

/**
 * Gets to know what becomes of one boat and of its commands. Called on the thread that drives the proxy, when the proxy is
 * done with the change: a listener may submit and withdraw commands. What it throws reaches neither the proxy nor other listeners.
 */
public interface BoatListener {

    /** A command is done. */
    default void onCompleted(String boatId, BoatCommand command) {}

    /** A command cannot be done, for a reason in words; it has left the queue. */
    default void onFailed(String boatId, BoatCommand command, String reason) {}

    /** A path failed and was given up. The boat holds its place until its next command, or until its link is lost. */
    default void onHoldsPlace(String boatId, BoatCommand givenUp) {}

    /** Another command has displaced this one for good; it has left the queue. What missions withdraw is not reported. */
    default void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {}

    /** Commands came into the queue or left it, or another one has its turn. */
    default void onQueueChanged(String boatId, CommandQueueSnapshot queue) {}

    /** The boat has taken the pictures of a panorama, and keeps them on board; completion follows. */
    default void onPanorama(String boatId, BoatCommand command, int pictures, GeoPoint from) {}

    /** More points of a path are behind the boat: how many, counted from the beginning of the path. */
    default void onProgress(String boatId, BoatCommand command, int visitedCount) {}

    /** A path has come further on its way to the boat, or has failed to. */
    default void onUpload(String boatId, Upload upload) {}

    /** A person at this base drives the boat by hand; its commands wait. */
    default void onTakenOver(String boatId) {}

    /** The person has given the boat back; its commands go on. */
    default void onReleased(String boatId) {}

    /** Telemetry has come. */
    default void onStatus(BoatStatus status) {}

    /** The link came or went. */
    default void onLinkChange(BoatStatus status) {}

    /** The battery's class was reported: when the link came, and at each change of class. */
    default void onBattery(String boatId, BatteryState battery) {}

    /**
     * The boat's server has started anew. It has forgotten all; nothing moves it until {@code BoatProxy.confirmRestart} says that
     * it may.
     */
    default void onRestarted(BoatStatus status) {}

    /** A boat that had started anew may be moved again. */
    default void onRestartAllowed(BoatStatus status) {}

    /** The base has given the boat up. */
    default void onRetired(String boatId) {}

    /** This base commands the boat from now on, or does so no longer. */
    default void onCommanding(String boatId, boolean commands) {}

    /** Another client wishes to command the boat; {@code HandOver.grantCommand} hands it over. */
    default void onCommandAsked(String boatId, String clientId) {}

    /** What one of the boat's sensors measured. */
    default void onReading(String boatId, BoatReading reading) {}

    /** The boat sends more than the base takes, still does so, or no longer does: what was left out. */
    default void onLeftOut(String boatId, LeftOut leftOut) {}

    /** The boat said which settings are in force on it: when the link came, and after each one that was set. */
    default void onTuning(String boatId, BoatTuning tuning) {}

    /** The boat took a setting: that of the command that {@code ProxySettings.setGains} and its like named. */
    default void onTuningTaken(String boatId, String commandId) {}

    /** The boat did not take a setting, for a reason in words. */
    default void onTuningRefused(String boatId, String commandId, String reason) {}

    /**
     * A listener threw an exception about a boat; all listeners still receive what follows.
     *
     * @param listener name of its class
     */
    default void onListenerFault(String listener, Throwable fault) {}

    /** The boat refuses this base, or a hand-over that it asked for; for a reason in words. */
    default void onRefused(String boatId, String reason) {}
}
