package org.sami.spn.plannet;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.spn.model.Transition;

/**
 * What a case of a firing asks of robots that are counted, from what it supposes of each of them. Each stands in one place at most, so how many stand where is all that
 * matters.
 */
final class CountedRobots {
    private final MissionPlaces places;
    private final List<String> spots;

    CountedRobots(MissionPlaces places, PossibleTokens possible, Transition t) {
        this.places = places;
        spots = possible.spots(t, PlanToken.ROBOTS).stream()
                .filter(place -> !possible.hasSub(place))
                .toList();
    }

    /**
     * The arcs of a case.
     *
     * @param robots one option for each robot; none where robots are named
     * @return empty where another case does the same and supposes less
     */
    Optional<CaseArcs> arcs(List<TokenOption> robots) {
        CaseArcs arcs = new CaseArcs();
        if (robots.isEmpty()) {
            return Optional.of(arcs);
        }
        Map<String, Integer> here = new TreeMap<>();
        boolean isOneAnywhere = false;
        for (TokenOption robot : robots) {
            robot.present.forEach(place -> here.merge(place, 1, Integer::sum));
            arcs.joinChanges(robot.arcs);
            isOneAnywhere |= robot.isAnywhere;
        }
        if (isOneAnywhere && robots.stream().anyMatch(robot -> robot.isAbsent() && robot.isStill())) {
            return Optional.empty(); // it may be anywhere as well: whether it is named changes nothing then
        }
        here.forEach((place, count) -> arcs.atLeast(at(place), count));
        if (!isOneAnywhere) {
            spots.forEach(place -> arcs.below(at(place), here.getOrDefault(place, 0) + 1));
        }
        return Optional.of(arcs);
    }

    private int at(String place) {
        return places.of(place, PlanToken.ROBOTS).getAsInt();
    }
}
