package org.sami.crw.session.near;

import java.util.Objects;
import java.util.Optional;
import org.sami.crw.proxy.near.NearBoat;
import org.sami.crw.proxy.near.NearBoat.State;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;

/**
 * A boat near: announced on the network, linked to the session, or both.
 *
 * @param name what the linked boat is called, else what the announcement says, else the address
 * @param found what is announced at the address; empty where nothing is
 * @param link of the session to the address; empty where it has none
 * @param elsewhere the address at which the session is linked to a boat of the announced id; empty where it is not
 */
public record NearRow(
        String name,
        BoatAddress address,
        Optional<NearBoat> found,
        Optional<LinkReport> link,
        Optional<BoatAddress> elsewhere) {

    /** State of the session's link to the boat. */
    public enum Link {
        /** It is linked. */
        CONNECTED,
        /** It was linked, or is being connected for the first time. */
        CONNECTING,
        /** It is tried, and does not answer or is refused. */
        FAILING,
        /** The session does not try the address. */
        NONE
    }

    public NearRow {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(address, "address");
        Objects.requireNonNull(found, "found");
        Objects.requireNonNull(link, "link");
        Objects.requireNonNull(elsewhere, "elsewhere");
    }

    /** State of the session's link to it. */
    public Link state() {
        if (link.isEmpty()) {
            return Link.NONE;
        } else if (link.get().connected()) {
            return boat().isPresent() ? Link.CONNECTED : Link.CONNECTING;
        }
        return link.get().failedTries() > 0 ? Link.FAILING : Link.CONNECTING;
    }

    /** The id of the boat to which the address leads; empty before one has answered. */
    public Optional<String> boat() {
        return link.flatMap(LinkReport::boatId);
    }

    /** Whether one press connects it: it is not tried yet, and this base has its key or needs none. */
    public boolean canConnect() {
        return link.isEmpty()
                && elsewhere.isEmpty()
                && found.filter(boat -> boat.state().canConnect()).isPresent();
    }

    /** Whether it has to be paired first. */
    public boolean needsPairing() {
        return link.isEmpty()
                && elsewhere.isEmpty()
                && found.map(NearBoat::state)
                        .filter(state -> state == State.PAIRING || state == State.NOT_PAIRED)
                        .isPresent();
    }

    /** The state in words, such as {@code connected}, {@code not paired} or {@code does not answer}. */
    public String words() {
        return switch (state()) {
            case CONNECTED -> "connected";
            case CONNECTING -> "connecting";
            case FAILING -> failing(link.orElseThrow());
            case NONE ->
                elsewhere
                        .map(at -> "connected at " + at)
                        .orElseGet(() -> found.map(NearBoat::stateWords).orElse(""));
        };
    }

    private static String failing(LinkReport tried) {
        return tried.boatId().isPresent() ? "link lost" : tried.refused() ? "refused" : "does not answer";
    }

    /** What to do so that it can be connected, or why it does not answer; empty text if nothing needs to be done, or nothing can be. */
    public String advice() {
        if (state() == Link.FAILING) {
            String why = link.orElseThrow().lastEvent();
            return (why.isEmpty() ? "" : why + "; ") + "it goes on being tried";
        } else if (state() != Link.NONE || elsewhere.isPresent()) {
            return "";
        }
        return switch (found.map(NearBoat::state).orElse(State.CONNECTED)) {
            case PAIRING -> "select it and press Pair";
            case NOT_PAIRED -> "have it show its words, then press Pair";
            case PLAIN_REFUSED -> "pair it, or start this program with --open if whoever reaches it may command it";
            case WITHDRAWN -> "pair it again if it is yours";
            case OTHER_VERSION -> "bring boat and base to one version";
            case CONNECTED, PAIRED, OPEN -> "";
        };
    }

    /** Why one press does not connect it, and what to do; empty if it does, or if the boat is linked already. */
    public Optional<String> whyNot() {
        if (canConnect() || state() == Link.CONNECTED || state() == Link.CONNECTING) {
            return Optional.empty();
        }
        return Optional.of(words() + (advice().isEmpty() ? "" : ", " + advice()));
    }

    /** Its charge for people, as it announces it; empty text if it does not. */
    public String announcedBattery() {
        return found.map(NearBoat::batteryWords).orElse("");
    }
}
