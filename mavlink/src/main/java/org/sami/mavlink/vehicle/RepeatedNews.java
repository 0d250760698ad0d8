package org.sami.mavlink.vehicle;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;
import org.sami.mavlink.address.MavlinkAddress;

/** Recognizes what a vehicle says once and what therefore comes once on each of its links, such as a text. Used by one thread. */
final class RepeatedNews {
    static final long WITHIN_MS = 5_000; // the slower link is behind by less

    private final Deque<News> recent = new ArrayDeque<>();

    private record News(Object what, long sinceMs, Set<MavlinkAddress> links) {}

    /** Whether it has come on another link already, as often as now on this one. */
    boolean isRepeated(Object what, MavlinkAddress link, long nowMs) {
        while (!recent.isEmpty() && nowMs - recent.getFirst().sinceMs() > WITHIN_MS) {
            recent.removeFirst();
        }
        for (News news : recent) {
            if (news.what().equals(what) && news.links().add(link)) {
                return true;
            }
        }
        recent.addLast(new News(what, nowMs, new HashSet<>(Set.of(link))));
        return false;
    }
}
