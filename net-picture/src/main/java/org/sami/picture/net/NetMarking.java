package org.sami.picture.net;

import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/**
 * What stands where in a mission.
 *
 * @param tokens of each marked place, in order of entry, by the place's id
 * @param visitedByNobody places that were entered by nobody and are awake
 * @param allocation the proxy of each task that is allocated
 */
public record NetMarking(Map<String, List<Token>> tokens, Set<String> visitedByNobody, Map<TaskId, String> allocation) {
    /** Nothing stands anywhere. */
    public static final NetMarking EMPTY = new NetMarking(Map.of(), Set.of(), Map.of());

    public NetMarking {
        Map<String, List<Token>> copy = new LinkedHashMap<>();
        tokens.forEach((place, there) -> copy.put(place, List.copyOf(there)));
        tokens = Collections.unmodifiableMap(copy);
        visitedByNobody = Set.copyOf(visitedByNobody);
        allocation = Map.copyOf(allocation);
    }

    /** That of a mission which is followed by its effects. */
    public static NetMarking of(FollowedMarking followed, long mission, Map<TaskId, String> allocation) {
        return new NetMarking(followed.marking(mission), followed.visitedByNobody(mission), allocation);
    }

    /** The tokens of a place. */
    public List<Token> at(String place) {
        return tokens.getOrDefault(place, List.of());
    }

    /** The places to which tokens have come since another marking; where none came, those in which others stand now. */
    public Set<String> newIn(NetMarking before) {
        Set<String> came = changedFrom(before);
        came.removeIf(place -> at(place).size() <= before.at(place).size());
        return came.isEmpty() ? changedFrom(before) : came;
    }

    private Set<String> changedFrom(NetMarking other) {
        Set<String> places = new HashSet<>(tokens.keySet());
        places.removeIf(place -> at(place).equals(other.at(place)));
        return places;
    }

    /** Whether tokens stand in a place, or nobody's visit keeps it awake. */
    public boolean isActive(String place) {
        return !at(place).isEmpty() || visitedByNobody.contains(place);
    }

    /** The proxy whose colour a token has: its own, or that of its task; none where it has none. */
    public Optional<String> proxyOf(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return Optional.of(proxy.proxy());
        }
        return token instanceof Token.Task task ? Optional.ofNullable(allocation.get(task.task())) : Optional.empty();
    }
}
