package org.sami.crw.proxy;

import java.util.Optional;
import java.util.function.Function;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LookoutReadings;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Motion;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.execution.CommandDriver;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoPoint;

/**
 * Takes what a boat says: keeps its {@link BoatCondition}, and gives answers to whoever asked. The part of a {@link BoatProxy} that listens; for the
 * proxy's thread, which settles the boat's commands afterwards.
 */
final class BoatMessages {
    /** Why a command is broken off by a fleet stop. */
    static final String FLEET_STOP = "the fleet was stopped";

    private static final double GROUND_M = 0.5; // what flies is on the ground below

    private final String boatId;
    private final BoatCondition condition;
    private final ProxyLink link;
    private final HandOver handOver;
    private final ProxySettings settings;
    private final LatchRequests latch;
    private final CommandDriver driver;
    private final DeferredEvents announcements;
    private long lastTelemetry = -1; // its sequence number, or that of a motion

    BoatMessages(
            String boatId,
            BoatCondition condition,
            ProxyLink link,
            HandOver handOver,
            ProxySettings settings,
            LatchRequests latch,
            CommandDriver driver,
            DeferredEvents announcements) {
        this.boatId = boatId;
        this.condition = condition;
        this.link = link;
        this.handOver = handOver;
        this.settings = settings;
        this.latch = latch;
        this.driver = driver;
        this.announcements = announcements;
    }

    /** Takes one message of the boat. */
    void take(Frame frame) {
        LinkMessage message = frame.message();
        if (message instanceof Telemetry telemetry) {
            if (frame.sequence() > lastTelemetry) {
                lastTelemetry = frame.sequence();
                telemetry(telemetry);
            }
        } else if (message instanceof Motion motion) {
            if (frame.sequence() > lastTelemetry) {
                lastTelemetry = frame.sequence();
                seen(motion.latDeg(), motion.lonDeg(), motion.headingRad(), motion.speedMps(), motion.mode());
            }
        } else if (message instanceof Ack ack) {
            answered(ack.commandId(), ack);
        } else if (message instanceof HeldWaypoints held) {
            answered(held.commandId(), held);
        } else if (message instanceof Nack nack) {
            refused(nack);
        } else if (message instanceof Progress progress) {
            progressed(progress);
        } else if (message instanceof BatteryReport report) {
            BatteryState battery = new BatteryState(report.percent(), report.level());
            condition.status = condition.status.with(battery);
            announcements.add(new FleetEvent.BatteryReported(boatId, battery));
        } else if (message instanceof SensorReport report) {
            BoatReading reading = BoatReading.of(report);
            if (LookoutReadings.isVessel(reading.sensor(), reading.values())) {
                condition.vesselSeenMs = condition.nowMs;
            }
            announcements.add(new FleetEvent.Measured(boatId, reading));
        } else if (message instanceof PanoramaReport report) {
            driver.taken(report);
        } else if (message instanceof SettingsReport report) {
            condition.stoppedBy = report.stoppedBy();
            latch.reported(report.stoppedBy());
            condition.stopSeen &= !report.stoppedBy().isEmpty();
            condition.home = report.home().map(home -> GeoPoint.of(home.latDeg(), home.lonDeg()));
            condition.error = report.error().map(error -> CrossTrackError.of(error.positionM(), error.driftMps()));
            condition.performance = report.performance();
            condition.wayHome.isTaken(!report.capabilities().cannot().containsKey(BoatCapabilities.WAYS_HOME));
            settings.reported(report);
        } else if (message instanceof Welcome welcome) {
            welcomed(welcome);
        } else if (message instanceof CommandAsked asked) {
            announcements.add(new FleetEvent.CommandAsked(boatId, asked.clientId()));
        } else if (message instanceof Goodbye goodbye) {
            condition.otherBoat = Optional.of(goodbye.boatId()).filter(id -> !id.equals(boatId));
            refuse(goodbye.reason());
        } // heartbeats have done their work by arriving; what only bases say is no concern of a base
    }

    private void refuse(String reason) {
        if (!reason.equals(condition.refusal)) {
            condition.refusal = reason;
            announcements.add(new FleetEvent.Refused(boatId, reason));
        }
    }

    private void welcomed(Welcome welcome) {
        if (!welcome.boatId().equals(boatId)) {
            condition.otherBoat = Optional.of(welcome.boatId());
            refuse("this boat is " + welcome.boatId());
            return;
        }
        condition.otherBoat = Optional.empty();
        boolean restarted = !link.bootId().isEmpty() && !link.bootId().equals(welcome.bootId());
        boolean news = link.state() != LinkState.LINKED;
        link.welcomed(welcome);
        condition.refusal = "";
        condition.awaitingProgress = true;
        handOver.settled();
        latch.welcomed();
        if (news || restarted) {
            lastTelemetry = -1;
            linkChanged();
        }
        if (restarted) {
            restarted();
        }
    }

    /** The boat's server is another one than the one that was known: nobody has allowed it to move yet. */
    void restarted() {
        driver.abandon("the boat's server has started anew");
        condition.unconfirmedRestart = true;
        condition.heldListId = Optional.empty(); // what the earlier start held says nothing of this one
        announce(FleetEvent.Restarted::new);
    }

    private void seen(double latDeg, double lonDeg, double headingRad, double speedMps, BoatMode mode) {
        condition.sighting = Optional.of(new Sighting(latDeg, lonDeg, headingRad, speedMps, mode, condition.nowMs));
    }

    private void telemetry(Telemetry telemetry) {
        seen(telemetry.latDeg(), telemetry.lonDeg(), telemetry.headingRad(), telemetry.speedMps(), telemetry.mode());
        condition.flies = telemetry.altM().isPresent();
        condition.givesWayTo = Optional.of(telemetry.givesWayTo()).filter(other -> !other.isEmpty());
        BoatPose pose = new BoatPose(
                new GeoPoint(
                        telemetry.latDeg(), telemetry.lonDeg(), telemetry.altM().orElse(0)),
                telemetry.headingRad(),
                telemetry.speedMps(),
                telemetry.boatTimeMs());
        Optional<BatteryState> battery =
                condition.status.battery().map(known -> new BatteryState(telemetry.batteryPercent(), known.level()));
        condition.status = condition.status.with(pose, battery, telemetry.mode());
        battery.ifPresent(
                known -> condition.flightUse.says(pose.position().altM() > GROUND_M, known.percent(), condition.nowMs));
        condition.drift.says(pose.position(), telemetry.mode(), telemetry.boatTimeMs());
        condition.wayHome.says(telemetry.mode());
        announce(FleetEvent.StatusReported::new);
        if (telemetry.mode() == BoatMode.FLEET_STOP) {
            condition.stopSeen = true;
            if (!condition.fleetStopped) {
                condition.fleetStopped = true;
                driver.abandon(FLEET_STOP);
            }
            driver.latched();
            return;
        }
        condition.fleetStopped &= latch.areWaiting();
        condition.stoppedFromHere &= condition.fleetStopped;
        if (link.isCommanding() && !condition.awaitingProgress) {
            driver.drives(telemetry.mode() == BoatMode.PATH, condition.nowMs);
        }
        if (driver.isDriving() && telemetry.mode() == BoatMode.PATH) {
            driver.at(pose.position(), canMove(telemetry), condition.nowMs);
        } else if (driver.isDriving() && !condition.awaitingProgress) {
            resync(); // it left its path by itself: it may have lost us when we did not lose it
        } else if (!condition.awaitingProgress) {
            driver.lies(pose.position(), condition.nowMs);
        }
    }

    private boolean canMove(Telemetry telemetry) {
        return telemetry.batteryPercent() > 0
                && settings.inForce().map(BoatTuning::velocityMultiplier).orElse(1.0) > 0;
    }

    /** Asks the boat for its state; until the answer the base sends it no command. */
    private void resync() {
        condition.awaitingProgress = true;
        link.hello(condition.nowMs);
    }

    private void progressed(Progress progress) {
        condition.heldListId = Optional.of(progress.listId());
        driver.holds(progress);
        if (condition.awaitingProgress && link.isCommanding()) {
            condition.awaitingProgress = false;
            driver.resume(progress, condition.nowMs);
        } else {
            driver.progressed(progress);
        }
    }

    private void answered(String commandId, LinkMessage answer) {
        if (!handOver.answered(commandId)
                && !settings.answered(commandId)
                && !latch.answered(commandId)) { // otherwise the next telemetry shows the result
            driver.answered(commandId, answer, condition.nowMs);
        }
    }

    private void refused(Nack nack) {
        settings.refused(nack);
        latch.refused(nack);
        boolean mayPass = !handOver.refused(nack) && driver.refused(nack);
        boolean lostThere = nack.reason() == NackReason.NOT_GREETED && !condition.awaitingProgress; // though not here
        if (mayPass || lostThere) {
            resync();
        }
    }

    /** The link was taken up, lost or closed. */
    void linkChanged() {
        if (link.state() != LinkState.LINKED) {
            handOver.linkLost();
            latch.linkLost();
        }
        condition.status = condition.status.with(link.state(), link.bootId());
        if (link.state() == LinkState.LOST && isToReturn()) {
            condition.wayHome.begin(condition.status.pose().map(BoatPose::position));
        }
        announce(FleetEvent.LinkChanged::new);
    }

    /** Whether the boat returns to its home when its link is lost. */
    private boolean isToReturn() {
        return !condition.fleetStopped
                && settings.inForce()
                        .map(BoatTuning::lostLinkAction)
                        .filter(LostLinkAction.RETURN::equals)
                        .isPresent();
    }

    /** Publishes an event that has the present status. */
    void announce(Function<BoatStatus, FleetEvent> news) {
        announcements.add(news.apply(condition.status));
    }
}
