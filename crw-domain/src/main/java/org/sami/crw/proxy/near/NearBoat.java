package org.sami.crw.proxy.near;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatAnnouncement.Access;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.Peer;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * A boat that was found, and whether this base can connect to it.
 *
 * @param found the boat
 * @param state whether it can be connected
 */
public record NearBoat(FoundBoat found, State state) {
    /** Whether a base can connect to a boat. */
    public enum State {
        /** This base is connected to its address. */
        CONNECTED("connected"),
        /** Both have the other's key. */
        PAIRED("paired"),
        /** Links are plain, and this base takes them. */
        OPEN("open to everybody"),
        /** It waits to be paired. */
        PAIRING("waits to be paired"),
        /** This base is not paired with it. */
        NOT_PAIRED("not paired"),
        /** Its links are plain, and this base refuses that. */
        PLAIN_REFUSED("plain, needs --open"),
        /** Its key was withdrawn at this base. */
        WITHDRAWN("its key was withdrawn"),
        /** It speaks another version of the link. */
        OTHER_VERSION("another version");

        private final String words;

        State(String words) {
            this.words = words;
        }

        /** For people. */
        public String words() {
            return words;
        }

        /** Whether it can be connected now. */
        public boolean canConnect() {
            return this == PAIRED || this == OPEN;
        }
    }

    /**
     * The boats, as a base sees them; reads its keys.
     *
     * @param connected addresses to which it is connected already
     * @throws IOException if its keys cannot be read
     */
    public static List<NearBoat> of(List<FoundBoat> boats, BaseProtection base, Set<BoatAddress> connected)
            throws IOException {
        KeyStoreFolder folder = new KeyStoreFolder(base.keysFolder());
        List<Fingerprint> paired = List.of();
        List<Fingerprint> withdrawn = List.of();
        if (folder.exists()) {
            KeyRing keys = folder.open();
            paired = keys.peers().stream().map(Peer::fingerprint).toList();
            withdrawn = keys.withdrawn();
        }
        List<NearBoat> near = new ArrayList<>();
        for (FoundBoat boat : boats) {
            State state = connected.contains(boat.address())
                    ? State.CONNECTED
                    : stateOf(boat, base, has(paired, boat), has(withdrawn, boat));
            near.add(new NearBoat(boat, state));
        }
        return near;
    }

    private static State stateOf(FoundBoat boat, BaseProtection base, boolean paired, boolean withdrawn) {
        BoatAnnouncement announced = boat.announcement();
        if (!announced.sameLink()) {
            return State.OTHER_VERSION;
        }
        if (announced.access() == Access.OPEN) {
            return base.isPlain(new InetSocketAddress(
                            boat.address().host(), boat.address().port()))
                    ? State.OPEN
                    : State.PLAIN_REFUSED;
        }
        if (withdrawn) {
            return State.WITHDRAWN;
        }
        if (paired) {
            return State.PAIRED;
        }
        return announced.access() == Access.PAIRING ? State.PAIRING : State.NOT_PAIRED;
    }

    private static boolean has(List<Fingerprint> keys, FoundBoat boat) {
        String key = boat.announcement().key();
        Stream<String> known = keys.stream().map(Fingerprint::shortText);
        return !key.isEmpty() && known.anyMatch(key::equals);
    }

    /** The state for people, with the version of another link. */
    public String stateWords() {
        return state == State.OTHER_VERSION
                ? state.words() + " (link " + found.announcement().linkVersion() + ")"
                : state.words();
    }

    /** Its charge for people; empty if not known. */
    public String batteryWords() {
        return found.announcement().batteryPercent().isPresent()
                ? found.announcement().batteryPercent().getAsInt() + " %"
                : "";
    }
}
