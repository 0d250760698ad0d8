package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.model.Transition;

/**
 * The cases of one transition in a net that follows only whether any robot stands in a place. For each set of in places in which robots stand, all ways in which the robots
 * can share these places are tried, and what the firing can do then: what it can do in one of these ways it may do, what it can do in all of them it surely can.
 */
final class PresenceCases {
    private static final int MOST_SPOTS = 4;
    private static final int MOST_SHARES = 20_000;

    private final PlanNetWork work;
    private final List<String> spots;
    private final Map<Set<String>, List<TokenOption>> fitting = new HashMap<>();

    /** A case that was found. */
    record Found(CaseArcs arcs, PlanNetFiring firing) {}

    /** Tries all cases of robots that stand in given places. */
    interface Trial {
        /**
         * Tries them.
         *
         * @param robots for each robot what can be with it
         * @param standings where each robot stands
         * @return by what they do
         */
        Map<Object, Found> cases(List<List<TokenOption>> robots, List<Set<String>> standings)
                throws PlanNetTooLargeException;
    }

    PresenceCases(PlanNetWork work, Transition t) {
        this.work = work;
        spots = work.possible().spots(t, PlanToken.ROBOTS);
    }

    /** Adds them to the net. */
    void add(String title, List<TokenOption> options, Trial trial) throws PlanNetTooLargeException {
        if (spots.size() > MOST_SPOTS) {
            throw new PlanNetTooLargeException("robots can stand in " + spots.size() + " in places of \"" + title
                    + "\"; at most " + MOST_SPOTS + " are looked at together");
        }
        List<Set<String>> subsets = subsets();
        int made = 0;
        for (Set<String> present : subsets) {
            List<Set<String>> within =
                    subsets.stream().filter(present::containsAll).toList();
            Map<Object, Found> may = new LinkedHashMap<>();
            Set<Object> surely = new HashSet<>();
            boolean isFirst = true;
            for (List<Set<String>> standings : shares(within, present)) {
                List<List<TokenOption>> robots = standings.stream()
                        .map(standing -> fitting.computeIfAbsent(standing, s -> fitting(options, s)))
                        .toList();
                Map<Object, Found> cases = trial.cases(robots, standings);
                may.putAll(cases);
                if (isFirst) {
                    surely.addAll(cases.keySet());
                }
                surely.retainAll(cases.keySet());
                isFirst = false;
            }
            for (Map.Entry<Object, Found> each : may.entrySet()) {
                made++;
                work.putFiring(
                        title,
                        each.getValue().firing(),
                        List.of(),
                        each.getValue().arcs(),
                        made);
                if (surely.contains(each.getKey())) {
                    work.isSure();
                }
            }
        }
    }

    private List<Set<String>> subsets() {
        List<Set<String>> subsets = new ArrayList<>();
        for (int bits = 0; bits < 1 << spots.size(); bits++) {
            Set<String> subset = new TreeSet<>();
            for (int i = 0; i < spots.size(); i++) {
                if ((bits & 1 << i) != 0) {
                    subset.add(spots.get(i));
                }
            }
            subsets.add(subset);
        }
        return subsets;
    }

    /** Each way in which all robots stand somewhere in some places so that in each of these there is one; equal robots are not told apart. */
    private List<List<Set<String>>> shares(List<Set<String>> within, Set<String> present)
            throws PlanNetTooLargeException {
        List<List<Set<String>>> shares = new ArrayList<>();
        share(within, 0, new ArrayList<>(), shares);
        shares.removeIf(standings -> {
            Set<String> together = new HashSet<>();
            standings.forEach(together::addAll);
            return !together.equals(present);
        });
        return shares;
    }

    private void share(List<Set<String>> within, int from, List<Set<String>> chosen, List<List<Set<String>>> shares)
            throws PlanNetTooLargeException {
        if (chosen.size() == work.robots()) {
            if (shares.size() >= MOST_SHARES) {
                throw new PlanNetTooLargeException(work.robots() + " robots can share " + within.size()
                        + " sets of in places in more than " + MOST_SHARES + " ways: ask about fewer robots");
            }
            shares.add(List.copyOf(chosen));
            return;
        }
        for (int i = from; i < within.size(); i++) {
            chosen.add(within.get(i));
            share(within, i, chosen, shares);
            chosen.remove(chosen.size() - 1);
        }
    }

    /** What can be with a robot that stands in these in places; who is in a sub-mission may be looked at as if it were not. */
    private List<TokenOption> fitting(List<TokenOption> options, Set<String> standing) {
        return options.stream()
                .filter(option -> option.isAnywhere
                        || (standing.containsAll(option.present)
                                && spots.stream()
                                        .filter(spot -> !work.possible().hasSub(spot))
                                        .allMatch(spot -> standing.contains(spot) == option.present.contains(spot))))
                .toList();
    }

    /** What a case asks of the presence of robots, and changes of it. */
    Optional<CaseArcs> arcs(List<TokenOption> robots, List<Set<String>> standings) {
        Set<String> before = new LinkedHashSet<>();
        Set<String> after = new LinkedHashSet<>();
        for (int i = 0; i < robots.size(); i++) {
            before.addAll(standings.get(i));
            after.addAll(robots.get(i).after(standings.get(i)));
        }
        CaseArcs arcs = new CaseArcs();
        for (String spot : spots) {
            if (before.contains(spot)) {
                arcs.atLeast(at(spot), 1);
            } else {
                arcs.below(at(spot), 1);
            }
        }
        before.stream().filter(place -> !after.contains(place)).forEach(place -> arcs.empty(at(place)));
        after.stream().filter(place -> !before.contains(place)).forEach(place -> arcs.set(at(place)));
        return Optional.of(arcs);
    }

    private int at(String place) {
        return work.places().of(place, PlanToken.ROBOTS).getAsInt();
    }
}
