package org.sami.crw.proxy;

import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.BoatPerformance;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.execution.ExpectedWayHome;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.explanation.Obstacle;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoPoint;

/**
 * What the base knows of a boat besides its commands: the latest status, and what keeps every command from it. Shared by a {@link BoatProxy}, which
 * does what the operator asks, and its {@link BoatMessages}, which take what the boat says.
 */
final class BoatCondition {
    private final ProxyLink link;

    /** The latest that is known of the boat. */
    BoatStatus status;

    /** Whether it flies: then waypoints have altitudes for it. */
    boolean flies;

    /** What the session's plans command. */
    RobotKind robots = RobotKind.ROBOT;

    /** The last known position of the boat, with its time; empty before the first report. */
    Optional<Sighting> sighting = Optional.empty();

    /** The time in milliseconds; it never runs back. */
    long vesselSeenMs = Long.MIN_VALUE / 2; // when the boat reported a vessel that is not of the base last

    long nowMs;

    /** Whether the boat still has to report its state; until then the base sends it no command. */
    boolean awaitingProgress;

    /** Whether the boat's server has restarted and still waits for the permission to move. */
    boolean unconfirmedRestart;

    /** Whether a person drives the boat by hand. */
    boolean takenOver;

    /** Whether the link is cut on purpose. */
    boolean disconnected;

    /** Whether a fleet stop was sent to the boat or is latched on it. */
    boolean fleetStopped;

    /** Whether it was sent from here, since this base started. */
    boolean stoppedFromHere;

    String stoppedBy = ""; // the client that latched the fleet stop, as the boat says

    /** Why the boat refused the link last; empty if it did not. */
    String refusal = "";

    boolean stopSeen; // it was seen stopped since the stop that it names was latched

    /** The boat that answers over this link, if it is another one. */
    Optional<String> otherBoat = Optional.empty();

    /** The list that the boat said last that it holds; the name is empty if it said that it holds none. */
    Optional<String> heldListId = Optional.empty();

    /** Where the boat returns to when its link is lost; empty for one that has not said, as older ones do not. */
    Optional<GeoPoint> home = Optional.empty();

    /** The boat to which it says that it gives way; empty for none. */
    Optional<String> givesWayTo = Optional.empty();

    /** How the boat is carried over ground while it does not drive. */
    final DriftTrack drift = new DriftTrack();

    /** How much charge it uses in the air. */
    final FlightUse flightUse = new FlightUse();

    /** The way on which the boat is expected to come home by itself. */
    final ExpectedWayHome wayHome = new ExpectedWayHome(() -> home);

    /** How far the boat may be off its path, as it has reported; empty without a report. */
    Optional<CrossTrackError> error = Optional.empty();

    /** How far, how fast and how narrowly the boat drives, as it has reported. */
    BoatPerformance performance = BoatPerformance.UNKNOWN;

    BoatCondition(String boatId, ProxyLink link) {
        this.link = link;
        status = BoatStatus.unknown(boatId);
    }

    /** Why plans cannot command it; empty where they can, and before its first report. */
    Optional<String> unfit() {
        return status.pose().isEmpty() ? Optional.empty() : robots.unfit(flies);
    }

    /** Takes the time of a call; an earlier one than before changes nothing. */
    void reached(long atMs) {
        nowMs = Math.max(nowMs, atMs);
    }

    /** Whether it says that a fleet stop is latched, and that its motors may turn all the same, which this base did not order. */
    boolean isStopOverridden() {
        return stopSeen
                && !stoppedBy.isEmpty()
                && status.link() == LinkState.LINKED
                && !link.isCommanding()
                && status.mode().filter(mode -> mode != BoatMode.FLEET_STOP).isPresent();
    }

    /** How the boat is carried over ground while it does not drive; empty for one that drives, or of which nothing is heard. */
    Optional<Drift> drift() {
        return status.link() == LinkState.LINKED
                ? drift.drift(error.map(CrossTrackError::positionM).stream()
                        .mapToDouble(Double::doubleValue)
                        .findFirst())
                : Optional.empty();
    }

    /** What keeps every command from the boat; empty if nothing does. */
    Optional<Obstacle> obstacle() {
        if (disconnected) {
            return Obstacle.because(Cause.LINK_LOST, "its link was cut on purpose");
        } else if (link.state() == LinkState.LOST) {
            return Obstacle.because(
                    Cause.LINK_LOST, "the link has been lost for " + (nowMs - link.lastReceivedMs()) / 1000 + " s");
        } else if (link.state() == LinkState.CONNECTING) {
            return refusal.isEmpty()
                    ? Obstacle.because(Cause.NEVER_ANSWERED, "the boat has not answered yet")
                    : Obstacle.because(Cause.REFUSES, "the boat refuses: " + refusal);
        } else if (!link.isCommanding()) {
            return Obstacle.because(
                    Cause.COMMANDED_ELSEWHERE,
                    link.replacedBy()
                            .map(other -> "this base was replaced by " + other.clientId())
                            .or(() -> (isStopOverridden() ? link.holder() : link.controller())
                                    .map(who -> who + " commands the boat"))
                            .orElse("another client commands the boat"));
        } else if (fleetStopped) {
            return Obstacle.because(
                    Cause.FLEET_STOPPED,
                    "it is stopped"
                            + (stoppedFromHere ? "" : stoppedBy.isEmpty() ? ", not from here," : " by " + stoppedBy)
                            + " until it is released");
        } else if (takenOver) {
            return Obstacle.because(Cause.TAKEN_OVER, "it is driven by hand");
        } else if (unconfirmedRestart) {
            return Obstacle.because(
                    Cause.STARTED_ANEW, "its server has started anew and nobody has allowed it to move again");
        }
        return awaitingProgress
                ? Obstacle.because(Cause.COMPARING, "the boat has not said yet what it holds")
                : Optional.empty();
    }
}
