package org.sami.crw.session.near;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.proxy.near.NearBoat;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.spn.value.NaturalOrder;

/**
 * The boats near a session at a moment.
 *
 * @param rows by name; one for each address
 * @param problems what cannot be read or looked for, a sentence each
 */
public record NearList(List<NearRow> rows, List<String> problems) {
    /** No boat, before anything is known. */
    public static final NearList NONE = new NearList(List.of(), List.of());

    private static final Comparator<NearRow> IN_ORDER = Comparator.comparing(NearRow::name, NaturalOrder.INSTANCE)
            .thenComparing(row -> row.address().toString());

    public NearList {
        rows = List.copyOf(rows);
        problems = List.copyOf(problems);
    }

    /** Merges announcements and the session's links by address. */
    static NearList of(List<NearBoat> near, List<LinkReport> links, List<String> problems) {
        Map<BoatAddress, LinkReport> byAddress = new HashMap<>();
        Map<String, BoatAddress> carriers = new HashMap<>();
        for (LinkReport link : links) {
            BoatAddress address = BoatAddress.of(link.address());
            byAddress.put(address, link);
            link.boatId().ifPresent(boat -> carriers.put(boat, address));
        }
        List<NearRow> rows = new ArrayList<>();
        Set<BoatAddress> listed = new HashSet<>();
        for (NearBoat boat : near) {
            BoatAddress address = boat.found().address();
            Optional<LinkReport> link = Optional.ofNullable(byAddress.get(address));
            String announced = boat.found().announcement().name();
            Optional<BoatAddress> elsewhere = Optional.ofNullable(
                            carriers.get(boat.found().announcement().boatId()))
                    .filter(carrier -> link.isEmpty());
            if (listed.add(address)) { // anybody may announce any address
                rows.add(new NearRow(
                        link.flatMap(LinkReport::boatId).orElse(announced),
                        address,
                        Optional.of(boat),
                        link,
                        elsewhere));
            }
        }
        byAddress.forEach((address, link) -> {
            if (listed.add(address)) {
                rows.add(new NearRow(
                        link.boatId().orElse(address.toString()),
                        address,
                        Optional.empty(),
                        Optional.of(link),
                        Optional.empty()));
            }
        });
        rows.sort(IN_ORDER);
        return new NearList(rows, problems);
    }
}
