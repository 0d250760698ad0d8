package org.sami.crw.session;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.operator.OperatorLog;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;
import org.sami.session.api.RefusedException;

/**
 * What an operator does with one boat of a session by hand. All methods may be called from any thread and return at once; what comes of them arrives on the front's
 * executor, a refusal as a {@link RefusedException}.
 */
final class BoatOrders {
    private final FleetConnector connector;
    private final Replies replies;
    private final SettingReplies settings;
    private final OperatorLog log;
    private final Optional<RememberedBoats> remembered;
    private volatile boolean drivingEnded;

    BoatOrders(
            FleetConnector connector,
            Replies replies,
            SettingReplies settings,
            OperatorLog log,
            Optional<RememberedBoats> remembered) {
        this.connector = connector;
        this.replies = replies;
        this.settings = settings;
        this.log = log;
        this.remembered = remembered;
    }

    // ---- who commands it, and driving it

    /** Takes the command of a boat, whoever had it before. Listeners receive the boat's answer. */
    CompletionStage<Void> takeCommand(String boat) {
        return tell(boat, "took the command of " + boat, proxy -> {
            checkLinked(proxy);
            remembered.ifPresent(memory -> memory.watched(boat, false));
            proxy.handOver().takeCommand();
        });
    }

    /** Asks the commander of a boat for its command. Listeners receive the answer. */
    CompletionStage<Void> askForCommand(String boat) {
        return tell(boat, "asked for the command of " + boat, proxy -> {
            checkLinked(proxy);
            proxy.handOver().askForCommand();
        });
    }

    /** Only watches a boat from now on: whoever wishes may command it. What missions want of it waits. */
    CompletionStage<Void> handOver(String boat) {
        return tell(boat, "only watches " + boat, proxy -> {
            checkLinked(proxy);
            remembered.ifPresent(memory -> memory.watched(boat, true));
            proxy.handOver().observe();
        });
    }

    /** Gives a boat's command to another base, by its client id, and watches. */
    CompletionStage<Void> handOver(String boat, String clientId) {
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
    CompletionStage<Void> teleoperate(String boat, double thrust, double rudder) {
        if (!(Math.abs(thrust) <= 1 && Math.abs(rudder) <= 1)) {
            return CompletableFuture.failedFuture(
                    new RefusedException("thrust and rudder are -1 to 1, not " + thrust + " and " + rudder));
        }
        return onBoat(boat, proxy -> {
            if (drivingEnded) {
                throw new RefusedException("the session ends: boats are driven by hand no longer");
            }
            checkCommanding(proxy);
            if (proxy.isFlying()) {
                throw new RefusedException(
                        boat + " flies, and is not flown by hand from here: its own radio control takes it over");
            }
            if (proxy.stop().where() != StopLatch.Where.NOWHERE) {
                throw new RefusedException(boat + " is stopped, release it first");
            }
            if (!proxy.isTakenOver()) { // it is driven many times a second
                log.add(Kind.BOAT, "drives " + boat + " by hand", boat);
            }
            proxy.teleoperate(thrust, rudder);
            return null;
        });
    }

    /** From now on driving by hand is refused: whoever does so, as in a window elsewhere, would take a boat over from its last command. From any thread. */
    void endDriving() {
        drivingEnded = true;
    }

    /**
     * Ends the block by which a mission keeps a boat for itself: its commands stay, and those of other missions have their turn again.
     * Refused where none keeps it. Gives the missions that did.
     */
    CompletionStage<List<Long>> clearBlock(String boat) {
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
    CompletionStage<Void> cancel(String boat, String commandId) {
        return onBoat(boat, proxy -> {
            if (!proxy.commands().cancel(commandId, "the operator cancelled it")) {
                throw new RefusedException(boat + " does not have the command " + commandId + " any longer");
            }
            log.add(Kind.BOAT, "cancelled " + commandId + " of " + boat, boat);
            return null;
        });
    }

    CompletionStage<Void> sendPathAgain(String boat) {
        return onBoat(boat, proxy -> {
            proxy.commands().sendPathAgain();
            return null;
        });
    }

    /** Gives a boat that was driven by hand back to the missions; it stops if none wants anything of it. */
    CompletionStage<Void> handBack(String boat) {
        return tell(boat, "gave " + boat + " back to the missions", BoatProxy::release);
    }

    /** Stops the motors of one boat, latched on it until {@link #release}. */
    CompletionStage<Void> stop(String boat) {
        return tell(boat, "stopped " + boat, BoatProxy::fleetStop);
    }

    /** Ends the stop of one boat, which goes on with what missions want of it. Refused where this base does not command it. */
    CompletionStage<Void> release(String boat) {
        return tell(boat, "released " + boat, proxy -> {
            checkCommanding(proxy);
            proxy.fleetRelease();
        });
    }

    // ---- settings

    CompletionStage<Void> setGains(String boat, GainAxis axis, Gains gains) {
        return set(
                boat,
                proxy -> proxy.settings().setGains(axis, gains),
                "set the " + axis.name().toLowerCase(Locale.ROOT) + " gains of " + boat + " to " + gains);
    }

    CompletionStage<Void> setVelocityMultiplier(String boat, double multiplier) {
        return set(
                boat,
                proxy -> proxy.settings().setVelocityMultiplier(multiplier),
                "set the velocity multiplier of " + boat + " to " + multiplier);
    }

    CompletionStage<Void> setLostLinkAction(String boat, LostLinkAction action) {
        return set(
                boat,
                proxy -> proxy.settings().setLostLinkAction(action),
                "set " + boat + " to " + action.name().toLowerCase(Locale.ROOT) + " when its link is lost");
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

    /** Asks or tells the proxy of a boat something on the fleet's thread. */
    <T> CompletionStage<T> onBoat(String boat, Function<BoatProxy, T> what) {
        return replies.on(connector.executor(), () -> what.apply(find(connector.boats(), boat)));
    }

    private static BoatProxy find(ProxyRegistry boats, String boat) {
        return boats.find(boat)
                .orElseThrow(() ->
                        new RefusedException("there is no boat '" + boat + "'; there " + namesOf(boats.boatIds())));
    }

    private static String namesOf(List<String> boats) {
        return boats.isEmpty() ? "is none" : (boats.size() == 1 ? "is " : "are ") + String.join(", ", boats);
    }
}
