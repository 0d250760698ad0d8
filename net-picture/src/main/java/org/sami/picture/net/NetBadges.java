package org.sami.picture.net;

import java.util.Map;
import java.util.Set;

/**
 * Small signs at vertices.
 *
 * @param breakpoints ids of vertices at which a run stops: a red dot
 * @param unvisited ids of vertices that no run visited: a dashed band around them
 * @param bounds how many tokens a place can have, such as {@code ≤ 2}, by the place's id: a small label
 */
public record NetBadges(Set<String> breakpoints, Set<String> unvisited, Map<String, String> bounds) {
    /** No vertex has one. */
    public static final NetBadges NONE = new NetBadges(Set.of(), Set.of());

    public NetBadges {
        breakpoints = Set.copyOf(breakpoints);
        unvisited = Set.copyOf(unvisited);
        bounds = Map.copyOf(bounds);
    }

    /** Signs of runs alone. */
    public NetBadges(Set<String> breakpoints, Set<String> unvisited) {
        this(breakpoints, unvisited, Map.of());
    }
}
