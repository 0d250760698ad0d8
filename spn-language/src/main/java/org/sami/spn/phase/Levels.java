package org.sami.spn.phase;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * How many actions must go before each: the longest way to it. An edge back to an action that is under way, as in a loop, does not
 * count.
 */
final class Levels {
    private final Map<String, List<String>> following;
    private final Map<String, List<String>> forward = new HashMap<>();
    private final List<String> finished = new ArrayList<>();
    private final Set<String> seen = new HashSet<>();

    Levels(Map<String, List<String>> following) {
        this.following = following;
    }

    /** Puts the level of each action, from 0, into a map. */
    void of(Collection<String> actions, Map<String, Integer> levels) {
        actions.forEach(this::visit);
        actions.forEach(action -> levels.put(action, 0));
        Collections.reverse(finished);
        for (String action : finished) {
            for (String follower : forward.getOrDefault(action, List.of())) {
                levels.merge(follower, levels.getOrDefault(action, 0) + 1, Math::max);
            }
        }
    }

    private void visit(String start) {
        if (!seen.add(start)) {
            return;
        }
        Set<String> underWay = new HashSet<>(Set.of(start));
        Deque<String> path = new ArrayDeque<>(List.of(start));
        Deque<Iterator<String>> left = new ArrayDeque<>();
        left.push(following.getOrDefault(start, List.of()).iterator());
        while (!path.isEmpty()) {
            String here = path.peek();
            if (!left.peek().hasNext()) {
                path.pop();
                left.pop();
                underWay.remove(here);
                finished.add(here);
                continue;
            }
            String follower = left.peek().next();
            if (!underWay.contains(follower)) {
                forward.computeIfAbsent(here, h -> new ArrayList<>()).add(follower);
            }
            if (seen.add(follower)) {
                underWay.add(follower);
                path.push(follower);
                left.push(following.getOrDefault(follower, List.of()).iterator());
            }
        }
    }
}
