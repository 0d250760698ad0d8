package org.sami.crw.session.near;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * Which boats of a list one press connects, and which it does not. Immutable.
 *
 * @param connects the addresses to connect to
 * @param left why others are not connected, a line each that begins with the boat
 */
public record ConnectAll(List<BoatAddress> connects, List<String> left) {
    public ConnectAll {
        connects = List.copyOf(connects);
        left = List.copyOf(left);
    }

    /** All that are paired or need no pairing, and are not connected; of several with one id the first. */
    public static ConnectAll of(NearList list) {
        List<BoatAddress> connects = new ArrayList<>();
        List<String> left = new ArrayList<>();
        Map<String, BoatAddress> taken = new HashMap<>();
        for (NearRow row : list.rows()) {
            if (row.canConnect()) {
                String id = row.found().orElseThrow().found().announcement().boatId();
                BoatAddress first = taken.putIfAbsent(id, row.address());
                if (first == null) {
                    connects.add(row.address());
                } else {
                    left.add(row.name() + " at " + row.address() + ": a boat of that id is connected at " + first);
                }
            } else {
                row.whyNot().ifPresent(why -> left.add(row.name() + ": " + why));
            }
        }
        return new ConnectAll(connects, left);
    }

    /** The result of the press in words: how many are connected, and which are not and why. */
    public String words(NearList now) {
        Set<BoatAddress> asked = Set.copyOf(connects);
        long connected = now.rows().stream()
                .filter(row -> asked.contains(row.address()) && row.state() == NearRow.Link.CONNECTED)
                .count();
        String done = asked.isEmpty()
                ? "No further boat can be connected now"
                : connected + " of " + asked.size() + " connected";
        String rest = leftWords(now);
        return rest.isEmpty() ? done : done + ". Not connected: " + rest;
    }

    /** The boats that are not connected now, grouped by reason. */
    private static String leftWords(NearList now) {
        Map<String, List<String>> byReason = new LinkedHashMap<>();
        for (NearRow row : now.rows()) {
            row.whyNot()
                    .ifPresent(why -> byReason.computeIfAbsent(row.words(), reason -> new ArrayList<>())
                            .add(row.name()));
        }
        List<String> reasons = new ArrayList<>();
        byReason.forEach((reason, names) -> reasons.add(String.join(", ", names) + " (" + reason + ")"));
        return String.join("; ", reasons);
    }
}
