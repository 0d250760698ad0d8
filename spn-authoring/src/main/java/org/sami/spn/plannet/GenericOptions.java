package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/**
 * What can be with the generic tokens when a transition fires. They are counted: each number that matters is a case of its own. The pool is in the order of the
 * in places, so requirements take the tokens of the first places first.
 */
final class GenericOptions {
    /** So many generic tokens of a place are followed where a requirement speaks of all of them. */
    private static final int FOLLOWED = 3;

    /** Of up to so many places as many are followed as there are robots, as each may bring one. */
    private static final int FEW_PLACES = 2;

    /** Of more places than these one token each: there is a case for each number in each of them. */
    private static final int SOME_PLACES = 4;

    private final MissionPlaces places;
    private final PossibleTokens possible;
    private final Transition t;
    private final Selections selections;
    private final int beyond;
    private final int followed;
    private final List<String> spots;

    /**
     * @param robots how many there are
     * @param beyond the control place that is marked where there were more tokens than are followed
     */
    GenericOptions(
            MissionPlaces places,
            PossibleTokens possible,
            Transition t,
            Selections selections,
            int robots,
            int beyond) {
        this.places = places;
        this.possible = possible;
        this.t = t;
        this.selections = selections;
        this.beyond = beyond;
        spots = possible.spots(t, PlanToken.GENERIC);
        followed = spots.size() > SOME_PLACES ? 1 : spots.size() > FEW_PLACES ? FOLLOWED : Math.max(FOLLOWED, robots);
    }

    List<GenericOption> all() {
        boolean byAll = false;
        int most = 0;
        for (Selections.Selector s : selections.all()) {
            if (possible.covers(s.requirement(), t, PlanToken.GENERIC)) {
                byAll |= s.requirement().takesAll() || s.isOf(TokenKind.SUB_MISSION_TOKENS);
                most = Math.max(most, s.requirement().n());
            }
        }
        List<GenericOption> options = new ArrayList<>();
        if (spots.isEmpty() || (!byAll && most <= 0)) {
            addPicks(new int[spots.size()], false, false, options);
        } else {
            count(new int[spots.size()], 0, byAll, byAll ? followed + 1 : most, options);
        }
        return options;
    }

    /** Each number of tokens in each place. */
    private void count(int[] counts, int next, boolean isExact, int most, List<GenericOption> options) {
        if (next == spots.size()) {
            addPicks(counts, true, isExact, options);
            return;
        }
        boolean isOne = !possible.isCopied(PlanToken.GENERIC);
        int limit = !isOne ? most : Arrays.stream(counts).limit(next).sum() > 0 ? 0 : 1;
        for (int count = 0; count <= limit; count++) {
            counts[next] = count;
            count(counts, next + 1, isExact, most, options);
        }
        counts[next] = 0;
    }

    private void addPicks(int[] counts, boolean isCounted, boolean isExact, List<GenericOption> options) {
        int here = Arrays.stream(counts).sum();
        List<Integer> numbers = selections.numbers().getOrDefault("ANY_TOKEN", List.of());
        int mixed = numbers.isEmpty() ? 0 : Math.min(here, numbers.get(numbers.size() - 1));
        boolean takesReturned = selections.all().stream().anyMatch(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS));
        int returned = 0;
        for (int i = 0; i < counts.length && takesReturned; i++) {
            returned += possible.hasSub(spots.get(i)) ? counts[i] : 0;
        }
        boolean isMade = selections.all().stream()
                .anyMatch(s ->
                        s.isOf(TokenKind.SUB_MISSION_TOKENS) && possible.makes(s.requirement(), t, PlanToken.GENERIC));
        for (int any = 0; any <= mixed; any++) {
            for (int back = 0; back <= returned; back++) {
                for (int made = 0; made <= (isMade ? followed + 1 : 0); made++) {
                    options.add(option(counts, isCounted, isExact, any, back, made));
                }
            }
        }
    }

    private GenericOption option(int[] counts, boolean isCounted, boolean isExact, int any, int back, int made) {
        GenericOption option = new GenericOption();
        option.returned = back + made;
        if (made > followed) {
            option.arcs.set(beyond);
        }
        int here = Arrays.stream(counts).sum();
        boolean isOne = !possible.isCopied(PlanToken.GENERIC);
        for (int i = 0; i < counts.length && isCounted; i++) {
            int at = places.of(spots.get(i), PlanToken.GENERIC).getAsInt();
            option.arcs.atLeast(at, counts[i]);
            int most = isExact ? followed + 1 : selectionsMost();
            boolean isTop = counts[i] >= most;
            if (!possible.isHeld(spots.get(i)) && !isTop && !(isOne && here > 0)) {
                option.arcs.below(at, counts[i] + 1);
            }
            if (isTop && isExact) {
                option.arcs.set(beyond);
            }
        }
        selections.numbers().keySet().forEach(group -> {
            int picked = group.equals("ANY_TOKEN") ? any : group.equals("GENERIC") ? here : 0;
            option.picked.put(group, picked);
            if ((group.equals("ANY_TOKEN") || group.equals("GENERIC")) && here > picked) {
                option.more.add(group);
            }
        });
        int removed = 0;
        int removedReturned = 0;
        int[] added = new int[selections.edges().size()];
        int[] fresh = new int[added.length];
        for (Selections.Selector s : selections.all()) {
            OutRequirement r = s.requirement();
            if (r.kind() == TokenKind.GENERIC && r.action() == Action.ADD && !r.takesAll()) {
                fresh[s.edge()] += r.n();
            } else if (possible.covers(r, t, PlanToken.GENERIC)) {
                int selected = selected(r, here, any, back);
                if (s.removes() && s.isOf(TokenKind.SUB_MISSION_TOKENS)) {
                    removedReturned = Math.max(removedReturned, selected);
                } else if (s.removes()) {
                    removed = Math.max(removed, selected);
                }
                if (s.adds()) {
                    added[s.edge()] = Math.max(added[s.edge()], selected);
                    if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
                        fresh[s.edge()] += made;
                    }
                }
            }
        }
        remove(option, counts, removed, removedReturned);
        List<String> from = new ArrayList<>(option.left);
        for (int edge = 0; edge < added.length; edge++) {
            int more = added[edge] + fresh[edge];
            if (more > 0) {
                String target = selections.target(edge);
                option.edges.add(edge);
                option.arcs.add(places.of(target, PlanToken.GENERIC).getAsInt(), more);
                places.counting(target, PlanToken.GENERIC).forEach(counter -> option.arcs.add(counter, more));
                String source = added[edge] > 0 && !from.isEmpty() ? from.remove(0) : "";
                option.moves.add(new PlanNetMove(words(more), source, target));
            }
        }
        from.forEach(place -> option.moves.add(new PlanNetMove(words(1), place, "")));
        return option;
    }

    private int selectionsMost() {
        return selections.all().stream()
                .filter(s -> possible.covers(s.requirement(), t, PlanToken.GENERIC))
                .mapToInt(s -> s.requirement().n())
                .max()
                .orElse(0);
    }

    private static String words(int count) {
        return count == 1 ? PlanToken.GENERIC.label() : count + " " + PlanToken.GENERIC.label();
    }

    private static int selected(OutRequirement r, int here, int any, int back) {
        if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
            return r.takesAll() ? back : Math.min(back, r.n());
        }
        if (r.takesAll()) {
            return here;
        }
        return Math.min(r.n(), r.kind() == TokenKind.ANY_TOKEN ? any : here);
    }

    /** The first of all, and the first of those in places with sub-missions. */
    private void remove(GenericOption option, int[] counts, int removed, int removedReturned) {
        int left = removed;
        int leftReturned = removedReturned;
        for (int i = 0; i < counts.length; i++) {
            int here = Math.min(counts[i], left);
            left -= here;
            if (possible.hasSub(spots.get(i))) {
                int returned = Math.min(counts[i], leftReturned);
                leftReturned -= returned;
                here = Math.max(here, returned);
            }
            if (here > 0) {
                String place = spots.get(i);
                int gone = here;
                option.left.add(place);
                option.arcs.remove(places.of(place, PlanToken.GENERIC).getAsInt(), gone);
                places.counting(place, PlanToken.GENERIC).forEach(counter -> option.arcs.remove(counter, gone));
            }
        }
    }
}
