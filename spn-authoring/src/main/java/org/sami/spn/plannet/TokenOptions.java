package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

/**
 * What can be with one robot or task when a transition fires: whether it is named, where it stands, which requirements select it, and what becomes of it. Where
 * a token can be there several times, it is followed whether it is there at all.
 */
final class TokenOptions {
    private final MissionPlaces places;
    private final PossibleTokens possible;
    private final Transition t;
    private final Selections selections;
    private final SubMissionCases subs;
    private final boolean speaksOfRelevant;
    private final Set<String> watched;
    private final boolean ends;

    /** @param ends whether the firing ends the mission: then nobody looks at the places that tokens leave */
    TokenOptions(
            MissionPlaces places,
            PossibleTokens possible,
            Transition t,
            Selections selections,
            SubMissionCases subs,
            boolean speaksOfRelevant,
            Set<String> watched,
            boolean ends) {
        this.places = places;
        this.possible = possible;
        this.t = t;
        this.selections = selections;
        this.subs = subs;
        this.speaksOfRelevant = speaksOfRelevant;
        this.watched = watched;
        this.ends = ends;
    }

    List<TokenOption> of(PlanToken token) {
        if (possible.makesTasks(t)) {
            return ofMaking(token);
        }
        List<TokenOption> options = new ArrayList<>();
        add(token, false, options);
        if (!t.inputs().isEmpty() && (speaksOfRelevant || t.waitFor() == WaitFor.ALL)) {
            add(token, true, options);
        }
        return options;
    }

    /** Where only tasks that the mission makes are named: they stand nowhere yet. */
    private List<TokenOption> ofMaking(PlanToken token) {
        List<TokenOption> options = new ArrayList<>();
        add(token, false, options);
        if (token.isMade() && speaksOfRelevant) {
            TokenOption made = new TokenOption(token, true, List.of(), true);
            made.arcs.remove(places.unmade(token), 1);
            for (Selections.Selector s : selections.all()) {
                if (possible.makes(s.requirement(), t, token)) {
                    made.edges.add(s.edge());
                }
            }
            enter(made);
            options.add(made);
        }
        return options;
    }

    private void add(PlanToken token, boolean isNamed, List<TokenOption> options) {
        List<String> spots = possible.spots(t, token);
        boolean byAll = selections.all().stream()
                .anyMatch(s -> s.requirement().takesAll()
                        && !s.isOf(TokenKind.RELEVANT)
                        && !s.isOf(TokenKind.SUB_MISSION_TOKENS)
                        && possible.covers(s.requirement(), t, token));
        boolean byNumber = selections.all().stream()
                .anyMatch(s ->
                        s.level() > 0 && !s.isOf(TokenKind.RELEVANT) && possible.covers(s.requirement(), t, token));
        boolean bySub = selections.all().stream()
                .anyMatch(s -> s.isOf(TokenKind.SUB_MISSION_TOKENS) && possible.covers(s.requirement(), t, token));
        boolean mustReport = !isNamed && spots.stream().anyMatch(watched::contains);
        if (!isNamed && !byAll && !mustReport) {
            TokenOption anywhere = TokenOption.anywhere(token, !byNumber);
            selections.numbers().keySet().stream()
                    .filter(group -> isCovered(anywhere, group))
                    .forEach(group -> anywhere.levels.put(group, 0));
            anywhere.isUnselected = !byNumber && !bySub;
            subs.returned(anywhere);
            options.add(anywhere);
        }
        if (ends && byAll && !isNamed && !byNumber && !bySub && !mustReport && isTakenAnywhere(token, spots)) {
            addFirst(token, spots, options);
        } else if (isNamed || byAll || byNumber || bySub || mustReport) {
            addPlaced(token, isNamed, spots, byAll || mustReport, byNumber || bySub, options);
        }
    }

    /** Whether a token of which there may be several goes wherever it stands, and nothing depends on where. */
    private boolean isTakenAnywhere(PlanToken token, List<String> spots) {
        return possible.isCopied(token)
                && spots.stream().allMatch(spot -> possible.isLoose(token, spot))
                && spots.stream().noneMatch(possible::hasSub)
                && selections.all().stream()
                        .anyMatch(s -> s.removes()
                                && s.requirement().takesAll()
                                && !s.isOf(TokenKind.RELEVANT) // it is not named
                                && possible.covers(s.requirement(), t, token));
    }

    /** A case for nowhere, and one for each place that is the first in which it stands: it goes from all. */
    private void addFirst(PlanToken token, List<String> spots, List<TokenOption> options) {
        for (int first = 0; first <= spots.size(); first++) {
            List<String> present = first < spots.size() ? List.of(spots.get(first)) : List.of();
            TokenOption option = new TokenOption(token, false, present, true);
            for (int i = 0; i < first; i++) {
                option.arcs.below(places.of(spots.get(i), token).getAsInt(), 1);
            }
            if (!present.isEmpty()) {
                option.arcs.atLeast(places.of(spots.get(first), token).getAsInt(), 1);
                spots.forEach(spot -> option.arcs.empty(places.of(spot, token).getAsInt()));
                option.left.addAll(present);
                option.removed.addAll(present);
                selections.all().stream()
                        .filter(s -> s.adds() && selects(s, option, false))
                        .forEach(s -> option.edges.add(s.edge()));
                enter(option);
            }
            options.add(option);
        }
    }

    private void addPlaced(
            PlanToken token,
            boolean isNamed,
            List<String> spots,
            boolean mustBeKnown,
            boolean mayBeSelected,
            List<TokenOption> options) {
        boolean canBeMade = selections.all().stream().anyMatch(s -> possible.makes(s.requirement(), t, token));
        for (List<String> present : standings(token, spots)) {
            boolean mattersAbsent = mustBeKnown || mayBeSelected || (isNamed && canBeMade);
            boolean mattersPresent = isNamed || mustBeKnown || mayBeSelected;
            if (present.isEmpty() ? !mattersAbsent : !mattersPresent) {
                continue;
            }
            if (!isNamed && present.stream().anyMatch(watched::contains)) {
                continue; // it has to report
            }
            TokenOption option = new TokenOption(token, isNamed, present, true);
            for (String spot : spots) {
                int at = places.of(spot, token).getAsInt();
                if (present.contains(spot)) {
                    option.arcs.atLeast(at, 1);
                } else if ((possible.isCopied(token) || present.isEmpty()) && !possible.isHeld(spot)) {
                    option.arcs.below(at, 1);
                }
            }
            addLevels(option, List.copyOf(selections.numbers().keySet()), 0, options);
            if (isNamed && !present.isEmpty() && isOtherwiseByItsRobot(token)) {
                TokenOption byRobot = option.again();
                byRobot.isNamedByRobot = true;
                addLevels(byRobot, List.copyOf(selections.numbers().keySet()), 0, options);
            }
        }
    }

    /** Whether it matters that a task is named itself: a requirement makes a token for each name, and none for a task of a robot that is named. */
    private boolean isOtherwiseByItsRobot(PlanToken token) {
        return token.type() == TokenType.TASK
                && selections.all().stream().anyMatch(s -> s.isOf(TokenKind.RELEVANT) && !s.removes());
    }

    /** Where it can stand: nowhere or in one place; in any of them where it can be there several times. */
    private List<List<String>> standings(PlanToken token, List<String> spots) {
        List<List<String>> standings = new ArrayList<>(List.of(List.of()));
        for (String spot : spots) {
            if (possible.isCopied(token)) {
                List<List<String>> more = new ArrayList<>();
                for (List<String> standing : standings) {
                    List<String> one = new ArrayList<>(standing);
                    one.add(spot);
                    if (possible.canStand(token, one)) {
                        more.add(one);
                    }
                }
                standings.addAll(more);
            } else {
                standings.add(List.of(spot));
            }
        }
        return standings;
    }

    /** Each choice of levels, then of what sub-missions bring back. */
    private void addLevels(TokenOption option, List<String> groups, int next, List<TokenOption> options) {
        if (next == groups.size()) {
            addReturned(option, options);
            return;
        }
        String group = groups.get(next);
        if (!isCovered(option, group)) {
            addLevels(option, groups, next + 1, options);
            return;
        }
        int most = option.present.isEmpty() && !group.equals("NAMED")
                ? 0
                : selections.numbers().getOrDefault(group, List.of()).size();
        for (int level = 0; level <= most; level++) {
            TokenOption one = option.again();
            one.levels.put(group, level);
            addLevels(one, groups, next + 1, options);
        }
    }

    /** Whether requirements of a group speak of it: those of relevant tokens only where it is named. */
    private boolean isCovered(TokenOption option, String group) {
        return selections.all().stream()
                .filter(s -> s.level() > 0 && Selections.group(s.requirement()).equals(group))
                .anyMatch(s -> possible.covers(s.requirement(), t, option.token)
                        && (option.isNamed || !s.isOf(TokenKind.RELEVANT))
                        && !(option.isNamedByRobot && s.isOf(TokenKind.RELEVANT) && !s.removes()));
    }

    private void addReturned(TokenOption option, List<TokenOption> options) {
        if (!subs.isSurelySelected(option)) {
            addEffects(option, false, 0, options);
        }
        boolean canReturn = selections.all().stream()
                .map(Selections.Selector::requirement)
                .filter(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS)
                .anyMatch(
                        r -> option.present.stream().anyMatch(possible::hasSub) || possible.makes(r, t, option.token));
        if (canReturn) {
            for (int least : selections.subMissionNumbers()) {
                addEffects(option, true, least, options);
            }
        }
    }

    /** @param least of sub-mission tokens, requirements of so many and more select it */
    private void addEffects(TokenOption option, boolean isReturned, int least, List<TokenOption> options) {
        boolean removed = false;
        boolean surely = false;
        Set<Integer> edges = new TreeSet<>();
        for (Selections.Selector s : selections.all()) {
            if (selects(s, option, isReturned)
                    && (s.requirement().takesAll()
                            || !s.isOf(TokenKind.SUB_MISSION_TOKENS)
                            || s.requirement().n() >= least)) {
                removed |= s.removes();
                surely |= s.removes() && s.requirement().takesAll() && !s.isOf(TokenKind.SUB_MISSION_TOKENS);
                if (s.adds()) {
                    edges.add(s.edge());
                }
            }
        }
        for (List<String> left : leavings(option, removed, surely, isReturned)) {
            TokenOption one = option.again();
            one.isReturned = isReturned;
            one.edges.addAll(edges);
            one.left.addAll(left);
            one.removed.addAll(removed ? option.present : List.of());
            for (String place : left) {
                int at = places.of(place, one.token).getAsInt();
                if (possible.isLoose(one.token, place)) {
                    one.arcs.empty(at);
                } else {
                    one.arcs.remove(at, 1);
                    places.counting(place, one.token).forEach(counter -> one.arcs.remove(counter, 1));
                }
            }
            enter(one);
            subs.returned(one);
            options.add(one);
        }
    }

    private boolean selects(Selections.Selector s, TokenOption option, boolean isReturned) {
        OutRequirement r = s.requirement();
        boolean isHere = !option.present.isEmpty();
        if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
            return isReturned;
        }
        if (r.kind() == TokenKind.RELEVANT && !s.removes()) {
            return option.isNamed && !option.isNamedByRobot && (s.level() == 0 || isReached(s, option));
        }
        if (!isHere || !possible.covers(r, t, option.token) || (r.kind() == TokenKind.RELEVANT && !option.isNamed)) {
            return false;
        }
        return s.level() == 0 || isReached(s, option);
    }

    private static boolean isReached(Selections.Selector s, TokenOption option) {
        int level = option.levels.getOrDefault(Selections.group(s.requirement()), 0);
        return level > 0 && level <= s.level();
    }

    /** From which places it goes: of several copies some can stay where only a number of them is taken, or some are in a sub-mission. */
    private List<List<String>> leavings(TokenOption option, boolean removed, boolean surely, boolean isReturned) {
        if (!removed) {
            return List.of(List.of());
        }
        boolean isOnce = option.present.stream().noneMatch(spot -> possible.isLoose(option.token, spot));
        boolean isMade = isReturned && option.present.stream().noneMatch(possible::hasSub);
        if (!possible.isCopied(option.token)) {
            return List.of(option.present);
        }
        List<List<String>> leavings = new ArrayList<>(List.of(List.of()));
        for (String spot : option.present) {
            boolean mustGo = surely && !possible.isHeld(spot);
            List<List<String>> next = new ArrayList<>(mustGo ? List.of() : leavings);
            for (List<String> leaving : leavings) {
                List<String> more = new ArrayList<>(leaving);
                more.add(spot);
                next.add(more);
            }
            leavings = next;
        }
        if (isOnce && !isMade) {
            leavings.remove(List.of()); // one that is selected goes from somewhere
        }
        return leavings;
    }

    private void enter(TokenOption option) {
        List<String> from = new ArrayList<>(option.left);
        for (int edge : option.edges) {
            String target = selections.target(edge);
            int at = places.of(target, option.token).getAsInt();
            if (possible.isLoose(option.token, target)) {
                option.arcs.set(at);
            } else {
                option.arcs.add(at, 1);
                places.counting(target, option.token).forEach(counter -> option.arcs.add(counter, 1));
            }
            option.moves.add(new PlanNetMove(option.token.label(), from.isEmpty() ? "" : from.remove(0), target));
        }
        from.forEach(place -> option.moves.add(new PlanNetMove(option.token.label(), place, "")));
    }
}
