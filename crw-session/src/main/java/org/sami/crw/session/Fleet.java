package org.sami.crw.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.FleetStopModel;
import org.sami.crw.operator.OperatorLog;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.session.api.FrontFleet;
import org.sami.session.api.LinkedBoat;
import org.sami.session.api.RefusedException;
import org.sami.session.record.FleetHistory;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.GeoPoint;

/**
 * The boats of a session, and what an operator does with them by hand. All methods may be called from any thread and return at once;
 * what comes of them arrives on the front's executor, a refusal as a {@link RefusedException}.
 */
public final class Fleet implements FrontFleet {
    private final FleetConnector connector;
    private final Replies replies;
    private final FleetConnections connections;
    private final BoatOrders orders;
    private final FleetHistory history;
    private final FleetStopModel stop;
    private final OperatorLog log;
    private final MissionTitles titles;
    private final Optional<RememberedBoats> remembered; // empty where a session is resumed by running its world again
    private final LostLinkWish lostLinkWish;
    private boolean stopped; // for the fleet's thread

    Fleet(
            FleetConnector connector,
            FleetListener listener,
            Replies replies,
            SettingReplies settings,
            FleetHistory history,
            Optional<RememberedBoats> remembered,
            FleetStopModel stop,
            OperatorLog log,
            MissionTitles titles,
            LostLinkWish lostLinkWish,
            Runnable beforeEach) {
        this.connector = connector;
        this.replies = replies;
        this.history = history;
        this.remembered = remembered;
        this.stop = stop;
        this.log = log;
        this.titles = titles;
        this.lostLinkWish = lostLinkWish;
        connections = new FleetConnections(connector, replies, log, remembered, beforeEach);
        orders = new BoatOrders(connector, replies, settings, log, remembered);
        listener.onEachBoat(this::found);
    }

    private void found(BoatProxy boat) {
        if (remembered.map(memory -> memory.isWatched(boat.boatId())).orElse(false)) {
            boat.handOver().observe();
        }
        if (stopped) {
            boat.fleetStop();
        }
    }

    // ---- which boats there are

    @Override
    public CompletionStage<String> connect(BoatAddress address) {
        return connections.connect(address);
    }

    @Override
    public CompletionStage<Boolean> disconnect(String boat) {
        return connections.disconnect(boat);
    }

    @Override
    public CompletionStage<Boolean> disconnect(BoatAddress address) {
        return connections.disconnect(address);
    }

    @Override
    public CompletionStage<List<String>> addSimulated(String name, GeoPoint start, int count) {
        return connections.addSimulated(name, start, count);
    }

    /** A boat of that name is known to be somewhere: missions may want things of it, which wait until an address leads to it. */
    public void expect(String boat) {
        connections.expect(boat);
    }

    /**
     * Connects again to the boats that the journal knows, except disconnected ones; simulated ones are launched again. Returns their ids.
     *
     * @param except addresses to leave out
     * @param exceptBoats ids of boats to which the caller connects itself
     * @param positions last positions of boats, by their names
     * @param notice receives simulated boats that cannot be launched
     */
    List<String> reconnect(
            Set<BoatAddress> except,
            Set<String> exceptBoats,
            Map<String, GeoPoint> positions,
            Consumer<String> notice) {
        return connections.reconnect(except, exceptBoats, positions, notice);
    }

    // ---- what is known of them

    /** The boats that are known, as they are now. */
    public CompletionStage<List<BoatStatus>> boats() {
        return onFleet(boats -> boats.all().stream().map(BoatProxy::status).toList());
    }

    @Override
    public CompletionStage<List<LinkedBoat>> linkedBoats() {
        return links().thenApply(links -> links.stream()
                .flatMap(link ->
                        link.boatId().stream().map(boat -> new LinkedBoat(boat, BoatAddress.of(link.address()))))
                .toList());
    }

    @Override
    public BoatFileSource files(LinkedBoat boat) {
        return connector.files(boat.address());
    }

    @Override
    public CompletionStage<List<LinkStatus>> linkStatuses(String boat) {
        return links().thenApply(links -> links.stream()
                .filter(link -> link.boatId().equals(Optional.of(boat)))
                .findFirst()
                .map(LinkReport::linkStatuses)
                .orElse(List.of()));
    }

    /** How the links stand. */
    public CompletionStage<List<LinkReport>> links() {
        return replies.of(connector.links());
    }

    /** Why a boat moves or does not. */
    @Override
    public CompletionStage<BoatExplanation> why(String boat) {
        return orders.onBoat(boat, proxy -> proxy.explain(titles));
    }

    /** What is known of the boats over all processes of the session; from any thread, at once. */
    public FleetHistory history() {
        return history;
    }

    /** Asks the proxies something on the fleet's thread; what is asked must be quick. */
    public <T> CompletionStage<T> ask(Function<ProxyRegistry, T> question) {
        return onFleet(question);
    }

    // ---- by hand

    @Override
    public CompletionStage<Void> takeCommand(String boat) {
        return orders.takeCommand(boat);
    }

    @Override
    public CompletionStage<Void> askForCommand(String boat) {
        return orders.askForCommand(boat);
    }

    @Override
    public CompletionStage<Void> handOver(String boat) {
        return orders.handOver(boat);
    }

    @Override
    public CompletionStage<Void> handOver(String boat, String clientId) {
        return orders.handOver(boat, clientId);
    }

    /** From now on driving by hand is refused. From any thread. */
    void endDriving() {
        orders.endDriving();
    }

    @Override
    public CompletionStage<Void> teleoperate(String boat, double thrust, double rudder) {
        return orders.teleoperate(boat, thrust, rudder);
    }

    @Override
    public CompletionStage<List<Long>> clearBlock(String boat) {
        return orders.clearBlock(boat);
    }

    @Override
    public CompletionStage<Void> cancel(String boat, String commandId) {
        return orders.cancel(boat, commandId);
    }

    @Override
    public CompletionStage<Void> sendPathAgain(String boat) {
        return orders.sendPathAgain(boat);
    }

    // ---- settings

    /** The settings that a boat said last are in force on it; empty before it said so. */
    public CompletionStage<Optional<BoatTuning>> settings(String boat) {
        return orders.onBoat(boat, proxy -> proxy.settings().inForce());
    }

    @Override
    public CompletionStage<Void> setGains(String boat, GainAxis axis, Gains gains) {
        return orders.setGains(boat, axis, gains);
    }

    @Override
    public CompletionStage<Void> setVelocityMultiplier(String boat, double multiplier) {
        return orders.setVelocityMultiplier(boat, multiplier);
    }

    @Override
    public CompletionStage<Void> setLostLinkAction(String boat, LostLinkAction action) {
        return orders.setLostLinkAction(boat, action);
    }

    @Override
    public Optional<LostLinkAction> lostLinkWish() {
        return lostLinkWish.now();
    }

    /** Begins with the wish that this process was started with; empty leaves that of the session's journal. */
    public void wish(Optional<LostLinkAction> action) {
        lostLinkWish.begin(action);
    }

    @Override
    public CompletionStage<Void> wishLostLink(Optional<LostLinkAction> action) {
        lostLinkWish.change(action);
        return CompletableFuture.completedStage(null);
    }

    // ---- driven by hand

    @Override
    public CompletionStage<Void> handBack(String boat) {
        return orders.handBack(boat);
    }

    @Override
    public CompletionStage<Void> stop(String boat) {
        return orders.stop(boat);
    }

    @Override
    public CompletionStage<Void> release(String boat) {
        return orders.release(boat);
    }

    /**
     * Stops the motors of every boat, latched on each, and of every boat that joins before {@link #releaseAll}. Returns the boats that received the
     * stop.
     */
    @Override
    public CompletionStage<List<String>> stopAll() {
        return onFleet(boats -> {
            stopped = true;
            stop.commanded(true);
            boats.fleetStop();
            log.add(Kind.FLEET_STOP, "stopped the fleet", Ids.NONE, boats.boatIds());
            return boats.boatIds();
        });
    }

    /** Ends the fleet stop; boats go on with their missions' commands. Returns the boats that received the release. */
    @Override
    public CompletionStage<List<String>> releaseAll() {
        return onFleet(boats -> {
            stopped = false;
            stop.commanded(false);
            boats.fleetRelease();
            log.add(Kind.FLEET_STOP, "released the fleet", Ids.NONE, boats.boatIds());
            return boats.boatIds();
        });
    }

    // ---- how

    private <T> CompletionStage<T> onFleet(Function<ProxyRegistry, T> what) {
        return replies.on(connector.executor(), () -> what.apply(connector.boats()));
    }
}
