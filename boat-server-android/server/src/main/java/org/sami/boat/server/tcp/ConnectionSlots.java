package org.sami.boat.server.tcp;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.boat.link.LinkDefaults;

/**
 * Decides which clients to drop where more connect than a boat serves. The commander is never dropped. Silent clients go first, the longest silent before the
 * others; then the newest observers; and last, of many clients that ask to command, the longest silent. So a client that asks to command always finds
 * a place.
 *
 * <p>Clients beyond the limit may stay for a moment: a base observes until it knows which boat it has found, and asks to command only then. For the boat's
 * thread.
 */
final class ConnectionSlots {
    private static final long UNDECIDED_MS = 2000;
    private static final int WAITING = 8;

    private final int places;

    /** So many clients may stay. */
    ConnectionSlots(int places) {
        this.places = places;
    }

    /** Most connections at a time, with those of clients that have not greeted yet. */
    int withWaiting() {
        return places + WAITING;
    }

    /** Drops the clients beyond the limit. */
    void clear(Collection<Client> clients, long nowMs) {
        for (Optional<Client> next = surplus(clients, nowMs); next.isPresent(); next = surplus(clients, nowMs)) {
            next.get().turnAway("the boat serves " + places + " clients, and another one needs the place", nowMs);
        }
    }

    /** Drops one client to make room for a new one: the longest without a greeting, otherwise the next in order. */
    void makeRoom(Collection<Client> clients, long nowMs) {
        Optional<Client> stranger = clients.stream()
                .filter(client -> !client.isGreeted())
                .min(Comparator.comparingLong(client -> client.connection().number()));
        if (stranger.isPresent()) {
            stranger.get().connection().close("it has not said who it is, and another one comes");
        } else {
            next(clients, nowMs).ifPresent(client -> client.connection().close("another one needs its place"));
        }
    }

    private Optional<Client> surplus(Collection<Client> clients, long nowMs) {
        List<Client> settled = clients.stream()
                .filter(client -> !client.isLeaving())
                .filter(client ->
                        client.isGreetedFor(nowMs, UNDECIDED_MS) || (client.isGreeted() && client.wishesToCommand()))
                .collect(Collectors.toList());
        return settled.size() > places ? next(settled, nowMs) : Optional.empty();
    }

    private static Optional<Client> next(Collection<Client> clients, long nowMs) {
        Comparator<Client> silence = Comparator.comparingLong(client -> client.silentForMs(nowMs));
        Comparator<Client> order =
                silence.thenComparing(client -> -client.connection().number());
        List<Client> others =
                clients.stream().filter(client -> !client.commands()).collect(Collectors.toList());
        Optional<Client> dead = clients.stream()
                .filter(client -> client.silentForMs(nowMs) > LinkDefaults.LINK_LOST_AFTER_MS)
                .max(order);
        Optional<Client> last = others.stream()
                .filter(client -> !client.wishesToCommand())
                .max(Comparator.comparingLong(client -> client.connection().number()));
        if (dead.isPresent()) {
            return dead;
        }
        return last.isPresent() ? last : others.stream().max(order);
    }
}
