package org.sami.mavlink.vehicle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * Chooses the link on which messages are sent to a vehicle: of those on which it is heard, the one that has lost least lately. The choice changes when another
 * is clearly better, or when the chosen one is silent. Used by one thread.
 */
final class LinkChoice {
    private static final long SILENT_MS = 2_500; // two heartbeats
    private static final double CLEARLY = 0.1; // of all messages, less lost
    private static final double NEW_PART = 0.02;
    private static final int NUMBERS = 256;
    private static final int AT_ONCE = 128; // a wider gap is an older message, or a sender that began again

    private final List<Heard> links = new ArrayList<>();
    private Optional<Heard> chosen = Optional.empty();

    /** How a vehicle is heard on a link. */
    private static final class Heard {
        private final MavlinkAddress link;
        private long atMs;
        private int next;
        private double lost;

        Heard(MavlinkAddress link, int number) {
            this.link = link;
            next = number;
        }

        boolean isSilent(long nowMs) {
            return atMs + SILENT_MS < nowMs;
        }

        void heard(int number, long nowMs) {
            int gap = Math.floorMod(number - next, NUMBERS);
            if (gap < AT_ONCE) {
                lost += NEW_PART * ((gap == 0 ? 0 : 1) - lost);
            }
            atMs = nowMs;
            next = (number + 1) % NUMBERS;
        }
    }

    void heard(MavlinkAddress link, int number, long nowMs) {
        Heard now = links.stream()
                .filter(each -> each.link.equals(link))
                .findFirst()
                .orElseGet(() -> {
                    Heard made = new Heard(link, number);
                    links.add(made);
                    return made;
                });
        now.heard(number, nowMs);
        Heard best = order(nowMs).get(0);
        if (chosen.filter(present -> !present.isSilent(nowMs) && best.lost + CLEARLY >= present.lost)
                .isEmpty()) {
            chosen = Optional.of(best);
        }
    }

    private List<Heard> order(long nowMs) {
        List<Heard> order = new ArrayList<>(links);
        order.sort(Comparator.comparing((Heard each) -> each.isSilent(nowMs))
                .thenComparing(each -> each.lost)
                .thenComparing(each -> each.link instanceof MavlinkAddress.Serial)); // slower than a network
        return order;
    }

    /** All links: first the chosen one, then the others, the best first. */
    List<MavlinkAddress> links(long nowMs) {
        List<Heard> order = order(nowMs);
        chosen.ifPresent(first -> {
            order.remove(first);
            order.add(0, first);
        });
        return order.stream().map(each -> each.link).toList();
    }
}
