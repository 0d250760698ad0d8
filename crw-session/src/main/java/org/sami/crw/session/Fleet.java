package org.sami.crw.session;

import java.util.List;
import java.util.Locale;
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
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
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
    private final SettingReplies settings;
    private final FleetHistory history;
    private final FleetStopModel stop;
    private final OperatorLog log;
    private final MissionTitles titles;
    private final Optional<RememberedBoats> remembered; // empty where a session is resumed by running its world again
    private final Runnable beforeTheFirst;
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
            Runnable beforeTheFirst) {
        this.connector = connector;
        this.replies = replies;
        this.settings = settings;
        this.history = history;
        this.remembered = remembered;
        this.stop = stop;
        this.log = log;
        this.titles = titles;
        this.lostLinkWish = lostLinkWish;
        this.beforeTheFirst = beforeTheFirst;
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

    /**
     * Connects to a boat's server, and keeps at it until {@link #disconnect}.
     *
     * @return the boat's id, when it has answered
     */
    @Override
    public CompletionStage<String> connect(BoatAddress address) {
        log.add(Kind.BOAT, "connected to " + address);
        return reach(address);
    }

    private CompletionStage<String> reach(BoatAddress address) {
        beforeTheFirst.run();
        Replies.Reply<String> reply = replies.open();
        connector.executor().execute(() -> {
            try {
                connector.connect(new BoatConnector.Request("", "", address.toString()), reply::complete);
            } catch (RuntimeException cannot) {
                reply.fail(new RefusedException(String.valueOf(cannot.getMessage())));
            }
        });
        return reply.stage();
    }

    /**
     * Gives up a boat and its address: its commands fail, it is stopped if its link works, and is then left alone. Missions keep it;
     * {@link Session#drop(String)} takes it out of them. Gives whether it was known.
     */
    @Override
    public CompletionStage<Boolean> disconnect(String boat) {
        return replies.of(connector.disconnect(boat)).thenApply(known -> disconnected(boat, known));
    }

    /** Gives up an address, and as {@link #disconnect(String)} the boat that it leads to. Gives whether it was known. */
    @Override
    public CompletionStage<Boolean> disconnect(BoatAddress address) {
        return replies.of(connector.disconnect(address)).thenApply(known -> disconnected(address.toString(), known));
    }

    private boolean disconnected(String what, boolean known) {
        if (known) {
            log.add(Kind.BOAT, "disconnected " + what);
        }
        return known;
    }

    /**
     * Adds simulated boats, which join when their servers answer.
     *
     * @param name of one boat; of several, what their numbers are put behind
     * @return their ids
     */
    @Override
    public CompletionStage<List<String>> addSimulated(String name, GeoPoint start, int count) {
        beforeTheFirst.run();
        return onFleet(boats -> {
            if (count < 1 || count > BoatConnector.MOST_CREATED) {
                throw new RefusedException("1 to " + BoatConnector.MOST_CREATED + " boats can be added, not " + count);
            }
            try {
                List<String> made = connector.create(name, "", start, count);
                log.add(Kind.BOAT, "added simulated boats: " + String.join(", ", made));
                return made;
            } catch (IllegalStateException | IllegalArgumentException cannot) {
                throw new RefusedException(String.valueOf(cannot.getMessage()));
            }
        });
    }

    /** A boat of that name is known to be somewhere: missions may want things of it, which wait until an address leads to it. */
    public void expect(String boat) {
        beforeTheFirst.run();
        connector.executor().execute(() -> connector.expect(boat));
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
        List<RememberedBoats.Remembered> known =
                remembered.map(RememberedBoats::all).orElse(List.of());
        known.forEach(boat -> expect(boat.boat()));
        for (RememberedBoats.Remembered boat : known) {
            if (boat.simulatedAt().isPresent()) {
                GeoPoint at =
                        positions.getOrDefault(boat.boat(), boat.simulatedAt().get());
                connector.executor().execute(() -> relaunch(boat.boat(), at, notice));
            } else if (!exceptBoats.contains(boat.boat())) {
                boat.address().filter(address -> !except.contains(address)).ifPresent(this::reach);
            }
        }
        return known.stream().map(RememberedBoats.Remembered::boat).toList();
    }

    private void relaunch(String boat, GeoPoint at, Consumer<String> notice) {
        try {
            connector.relaunch(boat, at);
        } catch (IllegalStateException cannot) {
            notice.accept(boat + " was simulated by an earlier process and is missing: " + cannot.getMessage()
                    + "; connect a boat of that name, or drop it");
        }
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
        return onBoat(boat, proxy -> proxy.explain(titles));
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

    /** Takes the command of a boat, whoever had it before. Listeners receive the boat's answer. */
    @Override
    public CompletionStage<Void> takeCommand(String boat) {
        return tell(boat, "took the command of " + boat, proxy -> {
            checkLinked(proxy);
            remembered.ifPresent(memory -> memory.watched(boat, false));
            proxy.handOver().takeCommand();
        });
    }

    /** Asks the commander of a boat for its command. Listeners receive the answer. */
    @Override
    public CompletionStage<Void> askForCommand(String boat) {
        return tell(boat, "asked for the command of " + boat, proxy -> {
            checkLinked(proxy);
            proxy.handOver().askForCommand();
        });
    }

    /** Only watches a boat from now on: whoever wishes may command it. What missions want of it waits. */
    @Override
    public CompletionStage<Void> handOver(String boat) {
        return tell(boat, "only watches " + boat, proxy -> {
            checkLinked(proxy);
            remembered.ifPresent(memory -> memory.watched(boat, true));
            proxy.handOver().observe();
        });
    }

    /** Gives a boat's command to another base, by its client id, and watches. */
    @Override
    public CompletionStage<Void> handOver(String boat, String clientId) {
        return tell(boat, "gave the command of " + boat + " to " + clientId, proxy -> {
            checkCommanding(proxy);
            proxy.handOver().grantCommand(clientId);
        });
    }

    /**
     * Drives a boat by hand: missions are notified, and their commands wait until {@link #handBack}. Without another call within two seconds the boat
     * stops its motors.
     *
     * @param thrust part of full thrust, -1 to 1
     * @param rudder part of full steering effort, -1 (port) to 1 (starboard)
     */
    @Override
    public CompletionStage<Void> teleoperate(String boat, double thrust, double rudder) {
        if (!(Math.abs(thrust) <= 1 && Math.abs(rudder) <= 1)) {
            return CompletableFuture.failedFuture(
                    new RefusedException("thrust and rudder are -1 to 1, not " + thrust + " and " + rudder));
        }
        return onBoat(boat, proxy -> {
            checkCommanding(proxy);
            if (!proxy.isTakenOver()) { // it is driven many times a second
                log.add(Kind.BOAT, "drives " + boat + " by hand", boat);
            }
            proxy.teleoperate(thrust, rudder);
            return null;
        });
    }

    /**
     * Ends the block by which a mission keeps a boat for itself: its commands stay, and those of other missions have their turn again.
     * Refused where none keeps it. Gives the missions that did.
     */
    @Override
    public CompletionStage<List<Long>> clearBlock(String boat) {
        return onBoat(boat, proxy -> {
            List<Long> kept = proxy.commands().clearBlocks();
            if (kept.isEmpty()) {
                throw new RefusedException("no mission keeps " + boat + " for itself");
            }
            log.add(Kind.BOAT, "cleared the block of " + boat + " by mission " + words(kept), boat);
            return kept;
        });
    }

    private static String words(List<Long> missions) {
        return String.join(", ", missions.stream().map(String::valueOf).toList());
    }

    /** Takes one command back from a boat's queue: for its mission it has failed. Refused where the boat does not have it any longer. */
    @Override
    public CompletionStage<Void> cancel(String boat, String commandId) {
        return onBoat(boat, proxy -> {
            if (!proxy.commands().cancel(commandId, "the operator cancelled it")) {
                throw new RefusedException(boat + " does not have the command " + commandId + " any longer");
            }
            log.add(Kind.BOAT, "cancelled " + commandId + " of " + boat, boat);
            return null;
        });
    }

    @Override
    public CompletionStage<Void> sendPathAgain(String boat) {
        return onBoat(boat, proxy -> {
            proxy.commands().sendPathAgain();
            return null;
        });
    }

    // ---- settings

    /** The settings that a boat said last are in force on it; empty before it said so. */
    public CompletionStage<Optional<BoatTuning>> settings(String boat) {
        return onBoat(boat, proxy -> proxy.settings().inForce());
    }

    @Override
    public CompletionStage<Void> setGains(String boat, GainAxis axis, Gains gains) {
        return set(
                boat,
                proxy -> proxy.settings().setGains(axis, gains),
                "set the " + axis.name().toLowerCase(Locale.ROOT) + " gains of " + boat + " to " + gains);
    }

    @Override
    public CompletionStage<Void> setVelocityMultiplier(String boat, double multiplier) {
        return set(
                boat,
                proxy -> proxy.settings().setVelocityMultiplier(multiplier),
                "set the velocity multiplier of " + boat + " to " + multiplier);
    }

    @Override
    public CompletionStage<Void> setLostLinkAction(String boat, LostLinkAction action) {
        return set(
                boat,
                proxy -> proxy.settings().setLostLinkAction(action),
                "set " + boat + " to " + action.name().toLowerCase(Locale.ROOT) + " when its link is lost");
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

    private CompletionStage<Void> set(String boat, Function<BoatProxy, String> ask, String done) {
        return settings.ask(connector.executor(), () -> {
            BoatProxy proxy = find(connector.boats(), boat);
            checkCommanding(proxy);
            try {
                String id = ask.apply(proxy);
                log.add(Kind.BOAT, done, boat);
                return id;
            } catch (IllegalArgumentException unfit) {
                throw new RefusedException(String.valueOf(unfit.getMessage()));
            }
        });
    }

    // ---- driven by hand

    /** Gives a boat that was driven by hand back to the missions; it stops if none wants anything of it. */
    @Override
    public CompletionStage<Void> handBack(String boat) {
        return tell(boat, "gave " + boat + " back to the missions", BoatProxy::release);
    }

    /** Stops the motors of one boat, latched on it until {@link #release}. */
    @Override
    public CompletionStage<Void> stop(String boat) {
        return tell(boat, "stopped " + boat, BoatProxy::fleetStop);
    }

    /** Ends the stop of one boat, which goes on with what missions want of it. */
    @Override
    public CompletionStage<Void> release(String boat) {
        return tell(boat, "released " + boat, BoatProxy::fleetRelease);
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

    private static void checkLinked(BoatProxy boat) {
        if (boat.status().link() != LinkState.LINKED) {
            throw new RefusedException("there is no link to " + boat.boatId() + " now");
        }
    }

    private static void checkCommanding(BoatProxy boat) {
        checkLinked(boat);
        if (!boat.isCommanding()) {
            throw new RefusedException("another base commands " + boat.boatId() + "; take its command first");
        }
    }

    /** @param done what the operator did then, for the log */
    private CompletionStage<Void> tell(String boat, String done, Consumer<BoatProxy> what) {
        return onBoat(boat, proxy -> {
            what.accept(proxy);
            log.add(Kind.BOAT, done, boat);
            return null;
        });
    }

    private <T> CompletionStage<T> onBoat(String boat, Function<BoatProxy, T> what) {
        return onFleet(boats -> what.apply(find(boats, boat)));
    }

    private static BoatProxy find(ProxyRegistry boats, String boat) {
        return boats.find(boat)
                .orElseThrow(() ->
                        new RefusedException("there is no boat '" + boat + "'; there " + namesOf(boats.boatIds())));
    }

    private static String namesOf(List<String> boats) {
        return boats.isEmpty() ? "is none" : (boats.size() == 1 ? "is " : "are ") + String.join(", ", boats);
    }

    private <T> CompletionStage<T> onFleet(Function<ProxyRegistry, T> what) {
        return replies.on(connector.executor(), () -> what.apply(connector.boats()));
    }
}
