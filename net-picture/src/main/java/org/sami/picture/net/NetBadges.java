package org.sami.picture.net;

import java.util.Set;

/**
 * Small signs at vertices.
 *
 * @param breakpoints ids of vertices at which a run stops: a red dot
 * @param unvisited ids of vertices that no run visited: a dashed band around them
 */
public record NetBadges(Set<String> breakpoints, Set<String> unvisited) {
    /** No vertex has one. */
    public static final NetBadges NONE = new NetBadges(Set.of(), Set.of());

    public NetBadges {
        breakpoints = Set.copyOf(breakpoints);
        unvisited = Set.copyOf(unvisited);
    }
}
