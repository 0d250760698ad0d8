package org.sami.mavlink.vehicle;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.mavlink.address.MavlinkAddress;

/**
 * Chooses the link on which messages are sent to a vehicle: of those on which it is heard, the one that has lost least lately; of equal ones a network before a
 * radio, and the radio with the stronger signal. Two that differ by no more than one lost message are equal. The choice changes when another is clearly better,
 * when the chosen one is silent, and from a radio to a network that is as good and has not been silent for a time. Used by one thread.
 */
final class LinkChoice {
    private static final long SILENT_MS = 2_500; // two heartbeats
    private static final double CLEARLY = 0.1; // of all messages, less lost
    private static final double NEW_PART = 0.02; // that the newest message makes of what is lost
    private static final int NUMBERS = 256;
    private static final int AT_ONCE = 128; // a wider gap is an older message, or a sender that began again

    private static final long STEADY_MS = 10_000; // without silence, before a network is used again in place of a radio
    private static final long FRESH_MS = 1_000; // within which what comes on other links is no news
    private static final int CLEARLY_STRONGER = 30; // of a radio's signal, some 15 dB
    private static final int PERCENT = 100;

    private final List<Heard> links = new ArrayList<>();
    private RadioSignals radios = RadioSignals.NONE;
    private Optional<Heard> chosen = Optional.empty();

    /** How a vehicle is heard on a link. */
    private static final class Heard {
        private MavlinkAddress link;
        private long atMs;
        private long steadySinceMs;
        private int next;
        private double lost;

        Heard(MavlinkAddress link, int number, long nowMs) {
            this.link = link;
            next = number;
            atMs = nowMs;
            steadySinceMs = nowMs;
        }

        boolean isSilent(long nowMs) {
            return atMs + SILENT_MS < nowMs;
        }

        void heard(int number, long nowMs) {
            int gap = Math.floorMod(number - next, NUMBERS);
            if (gap < AT_ONCE) {
                lost += NEW_PART * ((gap == 0 ? 0 : 1) - lost);
            }
            steadySinceMs = isSilent(nowMs) ? nowMs : steadySinceMs;
            atMs = nowMs;
            next = (number + 1) % NUMBERS;
        }
    }

    /**
     * A change of the chosen link.
     *
     * @param why what is wrong with the one before
     */
    record Change(MavlinkAddress before, MavlinkAddress now, String why) {}

    /** The vehicle was heard; what changed by that. */
    Optional<Change> heard(MavlinkAddress link, int number, long nowMs) {
        Heard now = links.stream()
                .filter(each -> each.link.equals(link))
                .findFirst()
                .orElseGet(() -> {
                    Heard made = new Heard(link, number, nowMs);
                    links.add(made);
                    return made;
                });
        now.heard(number, nowMs);
        Heard best = order(nowMs).get(0);
        Optional<Heard> before = chosen;
        if (before.isEmpty()) {
            chosen = Optional.of(best);
            return Optional.empty();
        }
        Optional<String> why = best == before.get() ? Optional.empty() : whyNot(before.get(), best, nowMs);
        why.ifPresent(any -> chosen = Optional.of(best));
        return why.map(words -> new Change(before.get().link, best.link, words));
    }

    /** Why another link is used in place of the present one; empty where it is not so much better. */
    private Optional<String> whyNot(Heard present, Heard best, long nowMs) {
        if (present.isSilent(nowMs)) {
            return Optional.of("has been silent for %.1f s".formatted((nowMs - present.atMs) / 1000.0));
        }
        if (best.lost + CLEARLY < present.lost) {
            return Optional.of("loses %.0f %% of its messages".formatted(present.lost * PERCENT));
        }
        boolean isAsGood = best.lost <= present.lost + NEW_PART;
        if (radios.isSlow(present.link) && !radios.isSlow(best.link)) {
            return isAsGood && nowMs - best.steadySinceMs >= STEADY_MS
                    ? Optional.of("has a radio in it, and loses no less")
                    : Optional.empty();
        }
        if (isAsGood && strength(best) > strength(present) + CLEARLY_STRONGER) {
            return Optional.of("has the weaker signal");
        }
        return Optional.empty();
    }

    /** A link was replaced by another one at the same port: what was known of it says nothing of that one, but it stays the one in use. */
    void moved(MavlinkAddress before, MavlinkAddress now) {
        links.stream().filter(each -> each.link.equals(before)).forEach(each -> {
            each.link = now;
            each.lost = 0;
        });
    }

    /** Which radios report themselves now. */
    void radios(RadioSignals now) {
        radios = now;
    }

    private int strength(Heard link) {
        return radios.strength(link.link);
    }

    /** Whether what comes on a link says how the vehicle is now: on the chosen one, and on any while that says nothing. */
    boolean isNews(MavlinkAddress link, long nowMs) {
        return chosen.filter(used -> !used.link.equals(link) && used.atMs + FRESH_MS >= nowMs)
                .isEmpty();
    }

    private List<Heard> order(long nowMs) {
        double least = links.stream()
                .filter(each -> !each.isSilent(nowMs))
                .mapToDouble(each -> each.lost)
                .min()
                .orElse(0);
        List<Heard> order = new ArrayList<>(links);
        order.sort(Comparator.comparing((Heard each) -> each.isSilent(nowMs))
                .thenComparing(each -> each.lost <= least + NEW_PART ? 0 : each.lost)
                .thenComparing(each -> radios.isSlow(each.link)) // slower than a network
                .thenComparing(Comparator.comparing(this::strength).reversed())
                .thenComparing(each -> each.lost));
        return order;
    }

    /** The chosen link; empty before the vehicle was heard. */
    Optional<MavlinkAddress> chosen() {
        return chosen.map(one -> one.link);
    }

    /** All links: first the chosen one, then the others, the best first. */
    List<HeardLink> links(long nowMs) {
        List<Heard> order = order(nowMs);
        chosen.ifPresent(first -> {
            order.remove(first);
            order.add(0, first);
        });
        return order.stream()
                .map(each -> new HeardLink(each.link, each.lost, each.atMs, radios.isSlow(each.link)))
                .toList();
    }
}
