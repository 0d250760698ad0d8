package org.sami.boat.server.tcp;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Who has to go where more clients come than a boat serves. Never the one who commands; first those from whom nothing comes any
 * longer, the longest silent before the others; then those who came last and only observe; and at last, of many who wish to command, the
 * longest silent. So a client that wishes to command always finds a place.
 *
 * <p>Clients beyond the places may stay for a moment: a base observes until it knows which boat it has found, and only then says
 * that it wishes to command. For the boat's thread.
 */
final class ConnectionSlots {
    private static final long DEAD_AFTER_MS = 3500;
    private static final long UNDECIDED_MS = 2000;
    private static final int WAITING = 8;

    private final int places;

    /** So many clients may stay. */
    ConnectionSlots(int places) {
        this.places = places;
    }

    /** How many may be connected at a time, with those who have not said who they are or what they wish. */
    int withWaiting() {
        return places + WAITING;
    }

    /** Has those go who are too many now. */
    void clear(Collection<Client> clients, long nowMs) {
        for (Optional<Client> next = surplus(clients, nowMs); next.isPresent(); next = surplus(clients, nowMs)) {
            next.get().turnAway("the boat serves " + places + " clients, and another one needs the place", nowMs);
        }
    }

    /** Drops one, so that another one can be heard: who has said nothing for longest, else who would have to go next. */
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
                .filter(client -> client.silentForMs(nowMs) > DEAD_AFTER_MS)
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
