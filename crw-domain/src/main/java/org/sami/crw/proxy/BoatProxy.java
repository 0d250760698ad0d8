package org.sami.crw.proxy;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Motion;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.WithdrawKeys;
import org.sami.boat.link.security.Fingerprint;
import org.sami.crw.fleet.DeferredEvents;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.execution.CommandDriver;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.explanation.Obstacle;
import org.sami.crw.proxy.link.Intake;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.proxy.link.ProxyLink;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.Drift;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.reach.Endurance;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoPoint;

/**
 * One boat as the base sees it: its link, its latest status, and the queue of commands that missions have for it.
 *
 * <p>The proxy makes the boat execute the command whose turn it is: it uploads the path under a new list id, reads it back, starts it, repeats
 * unanswered requests and follows the progress. After a lost link it compares the boat's list with the queue, and continues or uploads again. When
 * the last command is withdrawn, it stops the boat. A boat that completed its path keeps its station there; a boat whose path was given up holds its
 * place (docs/services.md).
 *
 * <p>For one thread, with milliseconds of one clock that never runs back. The {@link FrameSink} must not call back.
 */
public final class BoatProxy {
    private final String boatId;
    private final ProxyLink link;
    private final double usualSpeedMps;
    private final LatchRequests latch;
    private final HandOver handOver;
    private final DeferredEvents announcements;
    private final ProxySettings settings;
    private final CommandDriver driver;
    private final BoatCondition condition;
    private final BoatMessages messages;
    private final ProxyTraffic traffic;
    private final ProxyCommands commands;
    private final Intake intake = new Intake();
    private long announcedChanges; // of the queue

    /** A proxy that says hello at its first tick. */
    public BoatProxy(String boatId, FrameSink toBoat, Consumer<? super FleetEvent> listener, ProxyConfig config) {
        this.boatId = Objects.requireNonNull(boatId, "boatId");
        usualSpeedMps = config.cruiseSpeedMps();
        link = new ProxyLink(boatId, Objects.requireNonNull(toBoat, "toBoat"), config);
        announcements = new DeferredEvents(Objects.requireNonNull(listener, "listener"));
        condition = new BoatCondition(boatId, link);
        driver = new CommandDriver(
                boatId,
                config,
                link,
                announcements,
                this::position,
                this::cruiseSpeedMps,
                () -> condition.flies,
                condition.wayHome);
        handOver = new HandOver(boatId, link, config, announcements, condition, driver::wireId);
        latch = new LatchRequests(boatId, link, config, announcements, condition, driver::wireId);
        settings = new ProxySettings(boatId, link, config, announcements, condition, driver::wireId, this::settle);
        messages = new BoatMessages(boatId, condition, link, handOver, settings, latch, driver, announcements);
        traffic = new ProxyTraffic(condition, driver, link);
        commands = new ProxyCommands(driver, condition, this::settle);
    }

    private Optional<GeoPoint> position() {
        return condition.status.pose().map(BoatPose::position);
    }

    /** Where the boat returns to when its link is lost; empty for one that has not said, as older ones do not. */
    public Optional<GeoPoint> home() {
        return condition.home;
    }

    /**
     * The way on which the boat is expected to return home by itself since its link was lost: from its last position to its home, with the turns
     * between. It holds until the boat reports otherwise; empty for a boat that is not configured to return.
     */
    public List<GeoPoint> wayHome() {
        return condition.wayHome.way();
    }

    /** How far the boat may be off its path, as it has reported; empty without a report. */
    public Optional<CrossTrackError> error() {
        return condition.error;
    }

    /**
     * How far the boat may be off its path: as it has reported, and at least by its turning circle, as it leaves its path by that in corners.
     *
     * @param stated that of a boat which has reported none
     */
    public CrossTrackError errorOr(CrossTrackError stated) {
        CrossTrackError straight = condition.error.orElse(stated);
        return condition.performance.turningRadiusM().stream()
                .mapToObj(straight::turning)
                .findFirst()
                .orElse(straight);
    }

    /** Its battery's charge, and how far that takes it; empty before it has reported a charge. */
    public Optional<Charge> charge() {
        return condition.status.battery().map(battery -> battery.charge(condition.performance));
    }

    /** The same where it drives out at a speed in m/s. */
    public Optional<Charge> charge(double speedMps) {
        return condition.status.battery().map(battery -> battery.charge(condition.performance, speedMps));
    }

    /** How long its charge keeps it in the air; empty for one that does not fly, and before it has reported a charge. */
    public Optional<Endurance> endurance() {
        return condition
                .status
                .battery()
                .filter(battery -> condition.flies)
                .map(battery -> condition.flightUse.percentPerS().stream()
                        .mapToObj(perS -> Endurance.seen(battery.percent(), perS))
                        .findFirst()
                        .orElseGet(() -> Endurance.usual(battery.percent())));
    }

    /** What it was seen to use in the air. */
    public FlightUsed flightUsed() {
        return condition.flightUse.used();
    }

    /** Counts what an earlier base saw it use in the air, where nothing was seen since. */
    public void goOnFrom(FlightUsed earlier) {
        condition.flightUse.goOnFrom(earlier);
    }

    /** What it cannot do and what it measures, as it has reported. */
    public BoatCapabilities capabilities() {
        return settings.inForce().map(BoatTuning::capabilities).orElse(BoatCapabilities.UNKNOWN);
    }

    /** How far, how fast and how narrowly it drives, as it has reported. */
    public BoatPerformance performance() {
        return condition.performance;
    }

    /** How it is carried over ground while it does not drive; empty for one that drives, or of which nothing is heard. */
    public Optional<Drift> drift() {
        return condition.drift();
    }

    /** For how many milliseconds nothing has come from the boat; empty as long as nothing ever has. */
    public OptionalLong silentMs() {
        return link.bootId().isEmpty()
                ? OptionalLong.empty()
                : OptionalLong.of(Math.max(0, condition.nowMs - link.lastReceivedMs()));
    }

    /** Whether a person drives the boat by hand, so that its commands wait. */
    public boolean isTakenOver() {
        return condition.takenOver;
    }

    /** Whether it flies; false before its first report. */
    public boolean isFlying() {
        return condition.flies;
    }

    /** Says what the plans command that are to send it somewhere. */
    public void servesPlansOf(RobotKind robots) {
        condition.robots = robots;
    }

    /** Why those plans cannot command it, as {@code is a boat, and this session flies copters}; empty where they can, and before its first report. */
    public Optional<String> unfit() {
        return condition.unfit();
    }

    /** Names the boat. */
    public String boatId() {
        return boatId;
    }

    /** The speed in m/s at which it follows paths that name none: its own, or this base's for a boat that does not say it. */
    public double cruiseSpeedMps() {
        return condition.performance.cruiseMps().orElse(usualSpeedMps);
    }

    /** The radius of its narrowest turn at that speed, in metres; 0 for a boat that turns on the spot, or does not say it. */
    public double turningRadiusM() {
        return condition.performance.turningRadiusM().orElse(0);
    }

    /** The latest that is known of the boat. */
    public BoatStatus status() {
        return condition.status;
    }

    /** Whether the boat obeys a fleet stop of any base, as those do that number their commanders; boats of the link of before obey their commander's. */
    public boolean isStoppedByAnyone() {
        return link.state() == LinkState.LINKED && link.isNumbered();
    }

    /** Whether the boat takes commands from this base. */
    public boolean isCommanding() {
        return link.isCommanding();
    }

    /**
     * Whether no mission wants anything of the boat and it has answered all that was asked, so that nothing is under way. It may hold its
     * place meanwhile, since its path was given up.
     */
    public boolean isAtRest() {
        return driver.queue().size() == 0 && (driver.run().isEmpty() || driver.isHolding()) && !driver.isStopping();
    }

    /** How many frames could not be read. */
    public long unreadableFrames() {
        return link.unreadable();
    }

    /**
     * The base gives the boat up: every command fails for a reason in words, and a boat that is under way is stopped as soon as
     * it can be reached.
     */
    public void retire(String reason) {
        driver.failAll(reason);
        settings.giveUp(reason);
        condition.unconfirmedRestart = false;
        announcements.add(new FleetEvent.Retired(boatId));
        settle();
    }

    /** Every command fails, for a reason in words, and the boat stops its motors, whatever it does. */
    public void abort(String reason) {
        driver.failAll(reason);
        driver.stopWhenIdle();
        settle();
    }

    /** Whether the boat still has to be stopped, and its link works. */
    public boolean isBeingStopped() {
        return link.isCommanding() && driver.isStopping();
    }

    /**
     * Cuts the link: nothing goes to the boat any longer, nothing is taken from it, and it does what is set for a lost link. Commands
     * wait. Until {@link #reconnect} or {@link #fleetStop}.
     */
    public void disconnect() {
        condition.disconnected = true;
        if (link.closed()) {
            messages.linkChanged();
        }
        settle();
    }

    /** Takes the link up again after {@link #disconnect}; the boat then goes on with its commands. */
    public void reconnect() {
        if (condition.disconnected) {
            condition.disconnected = false;
            link.hello(condition.nowMs);
        }
    }

    /** Whether the link is cut on purpose. */
    public boolean isDisconnected() {
        return condition.disconnected;
    }

    /** Takes one whole frame from the boat. Returns whether it could be read. */
    public boolean receive(byte[] bytes, long atMs) {
        condition.reached(atMs);
        if (condition.disconnected) {
            return false;
        }
        Optional<Frame> frame = link.read(bytes);
        frame.ifPresentOrElse(read -> receive(read, atMs), this::settle);
        return frame.isPresent();
    }

    /** Takes a frame from a boat whose link carries no bytes. */
    public void receive(Frame frame, long atMs) {
        condition.reached(atMs);
        if (!condition.disconnected) {
            link.received(condition.nowMs);
            if (!intake.takes(frame, condition.nowMs)) {
                return;
            }
            messages.take(frame);
            if (!(frame.message() instanceof Motion)) { // no command depends on that, and it comes often
                settle();
            }
        }
    }

    /** So many frames of the boat were left out before they were read, as it sends too many. */
    public void leftOutUnread(long count) {
        intake.leftOutUnread(count, condition.nowMs);
    }

    /** The boat that answers over this link now, if it is another one. */
    public Optional<String> otherBoat() {
        return condition.otherBoat;
    }

    /** Lets time pass: heartbeats, lost links, requests that are sent again. To be called ten times a second. */
    public void tick(long atMs) {
        condition.reached(atMs);
        if (condition.disconnected) {
            return;
        }
        intake.due(condition.nowMs).forEach(messages::take);
        intake.news(condition.nowMs).ifPresent(news -> announcements.add(new FleetEvent.TooMuchSent(boatId, news)));
        if (link.tick(condition.nowMs)) {
            messages.linkChanged();
        }
        if (link.state() == LinkState.LINKED) {
            handOver.tick(condition.nowMs);
        }
        latch.tick();
        if (link.isCommanding()) {
            driver.tick(condition.nowMs);
            settings.tick(condition.nowMs);
            if (condition.awaitingProgress) {
                link.helloIfDue(condition.nowMs);
            }
        }
        settle();
    }

    /** The transport has opened: says hello at once. */
    public void opened(long atMs) {
        condition.reached(atMs);
        intake.linkEnded();
        condition.otherBoat = Optional.empty();
        if (!condition.disconnected) {
            link.hello(condition.nowMs);
        }
    }

    /** The transport has closed: the link is lost at once. */
    public void closed(long atMs) {
        condition.reached(atMs);
        intake.linkEnded();
        if (link.closed()) {
            messages.linkChanged();
        }
        settle();
    }

    /** The operator allows a boat whose server has restarted to be moved again. */
    public void confirmRestart() {
        if (condition.unconfirmedRestart) {
            condition.unconfirmedRestart = false;
            messages.announce(FleetEvent.RestartAllowed::new);
        }
        settle();
    }

    /**
     * Says which start of the boat's server was known last, from before this proxy. If it is another one that answers now, the boat
     * has restarted.
     */
    public void knownBoot(String bootId) {
        if (!link.bootId().isEmpty() && !link.bootId().equals(bootId) && !condition.unconfirmedRestart) {
            messages.restarted();
            settle();
        }
    }

    /**
     * Drives by hand; to be called again within two seconds, or the boat stops its motors. From the first call until
     * {@link #release} the commands wait.
     *
     * @param thrust part of full thrust, -1 to 1
     * @param rudder part of full steering effort, -1 (port) to 1 (starboard)
     */
    public void teleoperate(double thrust, double rudder) {
        Teleoperate hand = new Teleoperate(thrust, rudder);
        driver.abandon("the boat was taken over by hand");
        if (!condition.takenOver) {
            condition.takenOver = true;
            announcements.add(new FleetEvent.TakenOver(boatId));
        }
        if (link.isCommanding()) {
            link.send(hand, condition.nowMs);
        }
        settle();
    }

    /** Gives the boat back to the commands; it stops if there are none. */
    public void release() {
        if (condition.takenOver) {
            condition.takenOver = false;
            announcements.add(new FleetEvent.HandedBack(boatId));
            driver.stopWhenIdle();
            settle();
        }
    }

    /** What missions want of the boat, and how that stands. */
    public ProxyCommands commands() {
        return commands;
    }

    /** What can be set on the boat, and what it said is in force. */
    public ProxySettings settings() {
        return settings;
    }

    /** Who commands the boat, where several bases may. */
    public HandOver handOver() {
        return handOver;
    }

    /** Stops the motors, latched on the boat; commands wait until {@link #fleetRelease}. Takes up a link that was cut on purpose, to ask until it is answered. */
    public void fleetStop() {
        reconnect();
        condition.fleetStopped = true;
        condition.stoppedFromHere = true;
        driver.abandonMoving(BoatMessages.FLEET_STOP);
        latch.stop();
    }

    /**
     * Ends the fleet stop; the boat then goes on with its commands. Where this base does not command the boat now, or no longer before the boat has
     * answered, the boat stays stopped, and the listener gets {@link FleetEvent.ReleaseDropped}.
     */
    public void fleetRelease() {
        latch.release();
        settle();
    }

    /** Tells the boat which keys it takes no longer. What is not acknowledged is said again over the next connection. */
    public void withdrawKeys(List<Fingerprint> keys) {
        List<String> words = keys.stream().map(Fingerprint::toString).toList();
        link.send(new WithdrawKeys(driver.wireId("withdraw-keys"), words), condition.nowMs);
    }

    /** Whether the boat's motors are stopped until somebody releases them. */
    public StopLatch stop() {
        if (condition.isStopOverridden()) {
            return StopLatch.overridden(link.holder().orElse("somebody else"));
        }
        if (!condition.fleetStopped) {
            return StopLatch.NONE;
        }
        return condition.stoppedFromHere ? StopLatch.HERE : StopLatch.elsewhere(condition.stoppedBy);
    }

    /** Whether the boat has still to acknowledge a fleet stop or the release of one. */
    public boolean isAwaitingFleetAnswer() {
        return latch.areWaiting();
    }

    /** Why the boat moves or does not; missions are named by their numbers. */
    public BoatExplanation explain() {
        return explain(MissionTitles.NONE);
    }

    /** Why the boat moves or does not; missions are named by their numbers and plans. */
    public BoatExplanation explain(MissionTitles titles) {
        return explainer(titles).explain();
    }

    /** Whether it moves as it should; the same as {@link #explain()} says, without the words. */
    public boolean isUnderWay() {
        return explainer(MissionTitles.NONE).isUnderWay();
    }

    /** Position and destination of the boat, for the relay of traffic, and what it has received about other boats. */
    ProxyTraffic traffic() {
        return traffic;
    }

    private BoatExplainer explainer(MissionTitles titles) {
        return new BoatExplainer(boatId, driver, condition, settings, titles);
    }

    /** Makes the boat execute the command whose turn it is, then notifies the listener. */
    private void settle() {
        Optional<Obstacle> obstacle = condition.obstacle();
        if (obstacle.isPresent() && obstacle.get().cause() != BoatExplanation.Cause.COMPARING) {
            driver.endHold();
        }
        driver.settle(obstacle.isEmpty(), condition.nowMs);
        if (driver.queue().changes() != announcedChanges) {
            announcedChanges = driver.queue().changes();
            CommandQueueSnapshot queue = commands.queue();
            announcements.add(new FleetEvent.QueueChanged(boatId, queue));
        }
        announcements.deliver();
    }
}
