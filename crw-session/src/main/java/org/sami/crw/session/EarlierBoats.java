package org.sami.crw.session;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.archive.MapHistory;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.spn.value.GeoPoint;

/** The boats that earlier processes of a session had, as its journal knows them. For the time before the session begins. */
public final class EarlierBoats {
    private final SessionJournal journal;
    private final Fleet fleet;
    private final SessionMessages messages;

    EarlierBoats(SessionJournal journal, Fleet fleet, SessionMessages messages) {
        this.journal = journal;
        this.fleet = fleet;
        this.messages = messages;
    }

    /**
     * Connects again to the boats that were not disconnected; what missions want of them waits until they answer. Boats that an earlier process simulated
     * are launched again where they were last; they count as restarted. To be called once. Gives their ids.
     *
     * @throws IOException if the journal cannot be read
     */
    public List<String> reconnect() throws IOException {
        return reconnect(Set.of());
    }

    /** As {@link #reconnect()}, leaving out addresses to which the caller connects, or which hold no longer. */
    public List<String> reconnect(Set<BoatAddress> except) throws IOException {
        return fleet.reconnect(except, Set.of(), lastPositions(), messages::notice);
    }

    /** As {@link #reconnect()}, leaving out boats that have other addresses now, to which the caller connects; by their ids. */
    public List<String> reconnectWithout(Set<String> boats) throws IOException {
        return fleet.reconnect(Set.of(), boats, lastPositions(), messages::notice);
    }

    /**
     * Where earlier processes saw each boat last, by its id; for boats that are simulated again. Reads the journal.
     *
     * @throws IOException if the journal cannot be read
     */
    public Map<String, GeoPoint> lastPositions() throws IOException {
        return MapHistory.lastPositions(journal.earlier());
    }
}
