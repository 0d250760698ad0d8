package org.sami.spn.plannet;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.model.Transition;

/**
 * The sets of places in which one robot can stand at once, each with a place of the net that counts the robots of which this is true: so robots that are copied are
 * counted too. Immutable once all have their places.
 */
final class RobotProfiles {
    /** More sets than these are too many: the net would have more cases than one that names robots. */
    private static final int MOST = 40;

    private final PossibleTokens possible;
    private final Map<Set<String>, Integer> places = new LinkedHashMap<>();

    private RobotProfiles(PossibleTokens possible) {
        this.possible = possible;
    }

    /**
     * Follows one robot from its start.
     *
     * @param start where it stands at first; none where it stands nowhere
     * @param options what each transition can do with it
     * @param net gets a place for each set
     * @param robots how many robots there are
     * @return empty where there are too many sets
     */
    static Optional<RobotProfiles> of(
            Set<String> start,
            Map<Transition, List<TokenOption>> options,
            PossibleTokens possible,
            MissionPlaces net,
            int robots) {
        RobotProfiles profiles = new RobotProfiles(possible);
        Set<Set<String>> found = new LinkedHashSet<>(Set.of(Set.copyOf(start)));
        Deque<Set<String>> open = new ArrayDeque<>(found);
        while (!open.isEmpty()) {
            Set<String> from = open.removeFirst();
            options.forEach((t, all) -> all.stream()
                    .filter(option -> !option.isAnywhere && profiles.fits(option, t, from))
                    .map(option -> option.after(from))
                    .filter(found::add)
                    .forEach(open::add));
            if (found.size() > MOST) {
                return Optional.empty();
            }
        }
        for (Set<String> profile : found) {
            String words = String.join("+", new TreeSet<>(profile));
            profiles.places.put(
                    profile,
                    net.control(
                            "robots-at." + words,
                            "robots that stand in just " + (profile.isEmpty() ? "no place" : words),
                            profile.equals(start) ? robots : 0));
        }
        return Optional.of(profiles);
    }

    /** Whether an option can be of a robot that stands in just these places. */
    private boolean fits(TokenOption option, Transition t, Set<String> standing) {
        return standing.containsAll(option.present)
                && watched(t).stream().allMatch(spot -> standing.contains(spot) == option.present.contains(spot));
    }

    private List<String> watched(Transition t) {
        return possible.spots(t, PlanToken.ROBOTS).stream()
                .filter(place -> !possible.hasSub(place))
                .toList();
    }

    /** Each option with each set of places in which its robot can stand; where that makes no difference, as it is. */
    List<TokenOption> expanded(Transition t, Collection<TokenOption> options) {
        int watched = watched(t).size();
        List<TokenOption> expanded = new ArrayList<>();
        for (TokenOption option : options) {
            boolean isCountedAtPlaces = watched <= 1 || option.present.isEmpty();
            if (option.isAnywhere || (option.isStill() && isCountedAtPlaces)) {
                expanded.add(option);
            } else {
                places.keySet().stream()
                        .filter(standing -> fits(option, t, standing))
                        .forEach(standing -> expanded.add(moved(option, standing)));
            }
        }
        return expanded;
    }

    private TokenOption moved(TokenOption option, Set<String> from) {
        TokenOption moved = option.standingIn(from);
        moved.arcs.remove(at(from), 1);
        moved.arcs.add(at(option.after(from)), 1);
        return moved;
    }

    private int at(Set<String> profile) {
        return Objects.requireNonNull(places.get(profile), profile::toString);
    }
}
