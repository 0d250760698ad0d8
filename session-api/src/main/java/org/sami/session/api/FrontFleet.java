package org.sami.session.api;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.value.GeoPoint;

/**
 * What a front may do with the boats of a session, wherever that runs. Methods may be called from any thread and return at once; what comes of them arrives on the front's
 * executor, a refusal as a {@link RefusedException}.
 */
public interface FrontFleet {
    /** Connects to a boat's server, and keeps at it. Gives the boat's id when it has answered. */
    CompletionStage<String> connect(BoatAddress address);

    /** Gives up a boat and its address. Gives whether it was known. */
    CompletionStage<Boolean> disconnect(String boat);

    /** Gives up an address. Gives whether it was known. */
    CompletionStage<Boolean> disconnect(BoatAddress address);

    /** Adds simulated boats on the session's machine. Gives their ids. */
    CompletionStage<List<String>> addSimulated(String name, GeoPoint start, int count);

    /** Why a boat moves or does not. */
    CompletionStage<BoatExplanation> why(String boat);

    /** The boats that answer at an address, for {@link #files}. */
    CompletionStage<List<LinkedBoat>> linkedBoats();

    /** The links of MAVLink on which a boat is reached, the one in use first; none for boats of ours. */
    CompletionStage<List<LinkStatus>> linkStatuses(String boat);

    /** The files that a boat keeps, over a link that is not open yet. */
    BoatFileSource files(LinkedBoat boat);

    /** Takes the command of a boat, whoever had it before. */
    CompletionStage<Void> takeCommand(String boat);

    /** Asks the commander of a boat for its command. */
    CompletionStage<Void> askForCommand(String boat);

    /** Only watches a boat from now on. */
    CompletionStage<Void> handOver(String boat);

    /** Gives a boat's command to another base, by its client id. */
    CompletionStage<Void> handOver(String boat, String clientId);

    /**
     * Drives a boat by hand; to be repeated at least every {@value #DRIVE_MS} ms.
     *
     * @param thrust part of full thrust, -1 to 1
     * @param rudder part of full steering effort, -1 (port) to 1 (starboard)
     */
    CompletionStage<Void> teleoperate(String boat, double thrust, double rudder);

    /** How often a boat is driven by hand at least, in ms. */
    long DRIVE_MS = 300;

    /** Ends the block by which missions keep a boat for themselves. Gives those missions. */
    CompletionStage<List<Long>> clearBlock(String boat);

    /** Takes one command back from a boat's queue: for its mission it has failed. */
    CompletionStage<Void> cancel(String boat, String commandId);

    /** Has a boat be sent its path once more. */
    CompletionStage<Void> sendPathAgain(String boat);

    /** Sets the gains of one of a boat's control loops; completes when the boat has taken them, fails with its reason where it refuses. */
    CompletionStage<Void> setGains(String boat, GainAxis axis, Gains gains);

    /**
     * Scales the speed of every leg of a boat; as {@link #setGains}.
     *
     * @param multiplier 0 to {@link org.sami.boat.link.SetVelocityMultiplier#MAX_MULTIPLIER}
     */
    CompletionStage<Void> setVelocityMultiplier(String boat, double multiplier);

    /** Sets what a boat does when its link is lost; as {@link #setGains}. */
    CompletionStage<Void> setLostLinkAction(String boat, LostLinkAction action);

    /** What this session wishes that boats do when their link is lost; empty where it wishes nothing. */
    Optional<LostLinkAction> lostLinkWish();

    /** Changes {@link #lostLinkWish}, with which the checks before a launch compare each boat; no boat is set by it. */
    CompletionStage<Void> wishLostLink(Optional<LostLinkAction> action);

    /** Gives a boat that was driven by hand back to the missions. */
    CompletionStage<Void> handBack(String boat);

    /** Stops the motors of one boat until {@link #release}. */
    CompletionStage<Void> stop(String boat);

    /** Ends the stop of one boat. */
    CompletionStage<Void> release(String boat);

    /** Stops every boat, and those that join, until {@link #releaseAll}. Gives the boats that received it. */
    CompletionStage<List<String>> stopAll();

    /** Ends the fleet stop. Gives the boats that received the release. */
    CompletionStage<List<String>> releaseAll();
}
