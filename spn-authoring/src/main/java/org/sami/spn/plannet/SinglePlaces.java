package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/**
 * Looks for groups of places that together hold a copied token at most once: no firing puts more of it into the group than it takes out. In a place of such a group the
 * token never stands twice, and the net need not lose count of it there.
 *
 * <p>The proof goes firing by firing: supposing that each group has the token at most once, none has it twice afterwards. What enters is counted from above, what leaves
 * from below. In a place that no group has the token may stand any number of times.
 */
final class SinglePlaces {
    private static final int MOST_SPOTS = 6;
    private static final int MANY = 1_000;
    /** So many of the token a sub-mission may bring back from a place outside of a group: more than can leave the group. */
    private static final int SEVERAL = 2;

    private final Plan plan;
    private final TokenWays possible;
    private final boolean hasTasks;
    private final Predicate<PlanToken> several;
    private final Map<Transition, Selections> selections = new LinkedHashMap<>();

    /**
     * Looks at one plan.
     *
     * @param hasTasks whether the team has tasks: then a robot may be named that stands in no in place
     * @param several the tokens of which several may stand in the start place at first
     */
    SinglePlaces(Plan plan, TokenWays possible, boolean hasTasks, Predicate<PlanToken> several) {
        this.plan = plan;
        this.possible = possible;
        this.hasTasks = hasTasks;
        this.several = several;
        plan.transitions().forEach(t -> selections.put(t, new Selections(t, plan.outEdgesOf(t.id()))));
    }

    /** Groups for the places in which the token never stands twice: each of them is in one at least. */
    List<Set<String>> groups(PlanToken token) {
        return plan.places().stream()
                .map(Place::id)
                .filter(place -> possible.comes(place, token))
                .flatMap(place -> group(place, token).stream())
                .toList();
    }

    /** Adds places from which the token comes until the group has no more of it after any firing. */
    private Optional<Set<String>> group(String place, PlanToken token) {
        Set<String> group = new TreeSet<>(Set.of(place));
        while (!startsWithSeveral(group, token)) {
            Set<String> missing = null;
            for (Transition t : plan.transitions()) {
                for (Set<String> sources : sourcesOfMore(t, token, group)) {
                    if (sources.isEmpty()) {
                        return Optional.empty();
                    }
                    missing = missing == null || sources.size() < missing.size() ? sources : missing;
                }
            }
            if (missing == null) {
                return Optional.of(group);
            }
            group.add(missing.iterator().next());
        }
        return Optional.empty();
    }

    private boolean startsWithSeveral(Set<String> group, PlanToken token) {
        return several.test(token)
                && plan.startPlace().filter(start -> group.contains(start.id())).isPresent();
    }

    /** For each way in which a firing may leave more of the token in the group: where else it stood before. */
    private List<Set<String>> sourcesOfMore(Transition t, PlanToken token, Set<String> group) {
        List<String> spots = possible.spots(t, token);
        if (spots.size() > MOST_SPOTS) {
            return List.of(Set.of());
        }
        List<Set<String>> found = new ArrayList<>();
        for (int bits = 0; bits < 1 << spots.size(); bits++) {
            Set<String> present = new TreeSet<>();
            for (int i = 0; i < spots.size(); i++) {
                if ((bits & 1 << i) != 0) {
                    present.add(spots.get(i));
                }
            }
            Set<String> others = new TreeSet<>(present);
            others.removeAll(group);
            boolean isAtMostOnce = present.size() - others.size() <= 1;
            if (isAtMostOnce
                    && (mayGrow(t, token, false, present, group)
                            || (!t.inputs().isEmpty()
                                    && mayBeNamed(t, present)
                                    && mayGrow(t, token, true, present, group)))) {
                found.add(others);
            }
        }
        return found;
    }

    /** Whether one who stands there may be named: with no tasks in the team, all who are named stand where all of them are asked for. */
    private boolean mayBeNamed(Transition t, Collection<String> present) {
        return mayBeNamed(plan.inEdgesOf(t.id()), hasTasks, present);
    }

    static boolean mayBeNamed(List<InEdge> ins, boolean hasTasks, Collection<String> present) {
        return hasTasks
                || ins.stream()
                        .filter(edge -> edge.requirements().stream()
                                .anyMatch(r -> r.kind() == TokenKind.RELEVANT && r.match() == Match.ALL))
                        .allMatch(edge -> present.contains(edge.place()));
    }

    private boolean mayGrow(Transition t, PlanToken token, boolean isNamed, Set<String> present, Set<String> group) {
        List<Selections.Selector> all = selections.getOrDefault(t, new Selections(t, List.of())).all().stream()
                .filter(s -> isNamed || !s.isOf(TokenKind.RELEVANT))
                .filter(s -> possible.covers(s.requirement(), t, token) || possible.makes(s.requirement(), t, token))
                .toList();
        List<String> inside = present.stream().filter(possible::hasSub).toList();
        int returning = inside.stream()
                .mapToInt(place -> group.contains(place) ? 1 : SEVERAL)
                .sum();
        for (boolean isReturned : inside.isEmpty() ? new boolean[] {false} : new boolean[] {false, true}) {
            for (boolean isPicked : new boolean[] {false, true}) {
                int entering = 0;
                for (Selections.Selector s : all) {
                    if (s.adds() && group.contains(selections(t).target(s.edge()))) {
                        entering += entering(s, t, token, present.size(), isReturned ? returning : 0, isPicked);
                    }
                }
                if (entering > leaving(all, present, inside, group, isReturned, isPicked)) {
                    return true;
                }
            }
        }
        return false;
    }

    private Selections selections(Transition t) {
        return selections.getOrDefault(t, new Selections(t, List.of()));
    }

    /** How many of the token enter by one requirement at most. */
    private int entering(
            Selections.Selector s, Transition t, PlanToken token, int present, int returned, boolean isPicked) {
        OutRequirement r = s.requirement();
        if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
            return possible.makes(r, t, token) ? MANY : returned;
        }
        if (possible.makes(r, t, token)) {
            return s.level() > 0 ? Math.min(r.n(), Math.max(1, present)) : Math.max(1, present);
        }
        return s.level() == 0 ? present : isPicked ? Math.min(r.n(), present) : 0;
    }

    /** How many of the token leave the group at least: it stands there once at most. */
    private int leaving(
            List<Selections.Selector> all,
            Set<String> present,
            List<String> inside,
            Set<String> group,
            boolean isReturned,
            boolean isPicked) {
        String from = present.stream().filter(group::contains).findFirst().orElse("");
        if (from.isEmpty()) {
            return 0;
        }
        boolean isAllTaken = all.stream()
                .anyMatch(s -> s.removes() && s.requirement().takesAll() && !s.isOf(TokenKind.SUB_MISSION_TOKENS));
        List<Selections.Selector> returning =
                all.stream().filter(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS)).toList();
        List<Selections.Selector> picking =
                all.stream().filter(s -> s.level() > 0).toList();
        boolean leaves = (isAllTaken && !inside.contains(from))
                || (isReturned
                        && inside.equals(List.of(from))
                        && !returning.isEmpty()
                        && returning.stream().allMatch(Selections.Selector::removes))
                || (isPicked
                        && present.size() == 1
                        && !picking.isEmpty()
                        && picking.stream().allMatch(s -> s.requirement().action() != Action.ADD));
        return leaves ? 1 : 0;
    }
}
