package org.sami.crw.session;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.sami.crw.operator.OperatorLog;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.RefusedException;
import org.sami.spn.value.GeoPoint;

/**
 * Which boats a session has: addresses to which it connects, and boats that it simulates. All methods may be called from any thread and return at once; what comes
 * of them arrives on the front's executor, a refusal as a {@link RefusedException}.
 */
final class FleetConnections {
    private final FleetConnector connector;
    private final Replies replies;
    private final OperatorLog log;
    private final Optional<RememberedBoats> remembered;
    private final Runnable beforeEach;

    /**
     * Nothing is connected yet.
     *
     * @param remembered the boats that the journal knows; empty where a session is resumed by running its world again
     * @param beforeEach called each time before a boat is connected, added or expected
     */
    FleetConnections(
            FleetConnector connector,
            Replies replies,
            OperatorLog log,
            Optional<RememberedBoats> remembered,
            Runnable beforeEach) {
        this.connector = connector;
        this.replies = replies;
        this.log = log;
        this.remembered = remembered;
        this.beforeEach = beforeEach;
    }

    /**
     * Connects to a boat's server, and keeps at it until {@link #disconnect}.
     *
     * @return the boat's id, when it has answered
     */
    CompletionStage<String> connect(BoatAddress address) {
        log.add(Kind.BOAT, "connected to " + address);
        return reach(address);
    }

    private CompletionStage<String> reach(BoatAddress address) {
        beforeEach.run();
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
    CompletionStage<Boolean> disconnect(String boat) {
        return replies.of(connector.disconnect(boat)).thenApply(known -> disconnected(boat, known));
    }

    /** Gives up an address, and as {@link #disconnect(String)} the boat that it leads to. Gives whether it was known. */
    CompletionStage<Boolean> disconnect(BoatAddress address) {
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
    CompletionStage<List<String>> addSimulated(String name, GeoPoint start, int count) {
        beforeEach.run();
        return replies.on(connector.executor(), () -> {
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
    void expect(String boat) {
        beforeEach.run();
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
}
