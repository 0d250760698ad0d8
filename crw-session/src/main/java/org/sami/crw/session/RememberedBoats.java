package org.sami.crw.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/**
 * Keeps in the engine's memory, and so in the journal, where boats are reached, which of them the operator only watches and which were
 * simulated, so that a session that is resumed has its boats again. Safe for use by several threads.
 */
final class RememberedBoats {
    private static final String ADDRESS = "address/";
    private static final String WATCHED = "watched/";
    private static final String SIMULATED = "simulated/";
    private static final String YES = "yes";
    private static final String NO = "";

    private final EngineHost host;

    RememberedBoats(EngineHost host) {
        this.host = host;
    }

    /**
     * A boat of an earlier process.
     *
     * @param address where its server was; empty if it was disconnected
     * @param watched whether the operator had given its command away
     * @param simulatedAt where it was launched, if it was simulated and ended with its process
     */
    record Remembered(String boat, Optional<BoatAddress> address, boolean watched, Optional<GeoPoint> simulatedAt) {}

    void simulatedAt(String boat, GeoPoint start) {
        host.post(new Input.Remember(Ids.NONE, SIMULATED + boat, start));
    }

    void reachedAt(String boat, BoatAddress address) {
        remember(ADDRESS + boat, address.toString());
    }

    void gone(String boat) {
        remember(ADDRESS + boat, NO);
        remember(WATCHED + boat, NO);
        if (simulatedAt(boat).isPresent()) {
            host.post(new Input.Remember(Ids.NONE, SIMULATED + boat, new TextValue(NO)));
        }
    }

    void watched(String boat, boolean watched) {
        remember(WATCHED + boat, watched ? YES : NO);
    }

    boolean isWatched(String boat) {
        return memory(WATCHED + boat).equals(YES);
    }

    /** All boats that the engine knows. */
    List<Remembered> all() {
        List<Remembered> boats = new ArrayList<>();
        for (String boat : host.ask(view -> List.copyOf(view.proxies()))) {
            String address = memory(ADDRESS + boat);
            boats.add(new Remembered(
                    boat,
                    address.isEmpty() ? Optional.empty() : Optional.of(BoatAddress.parse(address)),
                    isWatched(boat),
                    simulatedAt(boat)));
        }
        return boats;
    }

    private Optional<GeoPoint> simulatedAt(String boat) {
        return host.ask(view -> view.memory(Ids.NONE, SIMULATED + boat))
                .filter(GeoPoint.class::isInstance)
                .map(GeoPoint.class::cast);
    }

    private void remember(String key, String value) {
        if (!memory(key).equals(value)) {
            host.post(new Input.Remember(Ids.NONE, key, new TextValue(value)));
        }
    }

    private String memory(String key) {
        return host.ask(view -> view.memory(Ids.NONE, key))
                .filter(TextValue.class::isInstance)
                .map(value -> ((TextValue) value).value())
                .orElse(NO);
    }
}
