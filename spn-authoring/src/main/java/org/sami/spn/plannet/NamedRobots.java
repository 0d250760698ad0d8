package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.net.FiringRule;

/** Names the robots in a run of a net that counts them: at each firing the first by name of those who can be meant. For one run. */
final class NamedRobots {
    private final PlanNet net;
    private final CountedParts counted;

    /** The places in which each robot stands. */
    private final Map<String, Set<String>> at = new LinkedHashMap<>();

    NamedRobots(PlanNet net, CountedParts counted) {
        this.net = net;
        this.counted = counted;
        net.request().robots().forEach(robot -> at.put(robot, counted.start()));
    }

    PlanRun run(FiringSequence run) {
        int[] marking = net.net().initialMarking();
        List<PlanNetFiring> firings = new ArrayList<>();
        List<PlanMarking> markings = new ArrayList<>(List.of(named(net.marking(marking))));
        for (int transition : run.transitions()) {
            firings.add(fired(transition));
            marking = FiringRule.fire(net.net(), transition, marking);
            markings.add(named(net.marking(marking)));
        }
        return new PlanRun(firings, markings);
    }

    private PlanNetFiring fired(int transition) {
        PlanNetFiring firing = net.firing(transition);
        List<String> named = new ArrayList<>();
        List<PlanNetMove> moves = new ArrayList<>();
        Set<String> used = new HashSet<>();
        List<TokenOption> options = counted.options().get(transition).stream()
                .filter(option -> !option.isAnywhere)
                .sorted(Comparator.comparing((TokenOption option) -> option.standing.isEmpty())
                        .thenComparing(TokenOption::isAbsent)) // who is nowhere else is absent
                .toList();
        Map<String, Set<String>> to = new LinkedHashMap<>(at);
        for (TokenOption option : options) {
            String robot = free(used, standing -> fits(option, standing));
            used.add(robot);
            if (option.isNamed) {
                named.add(robot);
            }
            for (PlanNetMove move : option.moves) {
                moves.add(new PlanNetMove(robot, move.from(), move.to()));
            }
            to.put(robot, option.after(at.getOrDefault(robot, Set.of())));
        }
        at.putAll(to);
        List<PlanNetMove> all = new ArrayList<>(firing.moves().stream()
                .filter(move -> !net.isRobot(move.token()))
                .toList());
        moves.sort(Comparator.comparing(move -> net.request().robots().indexOf(move.token())));
        all.addAll(moves);
        named.sort(Comparator.comparing(net.request().robots()::indexOf));
        firing.named().stream().filter(token -> !net.isRobot(token)).forEach(named::add);
        return new PlanNetFiring(firing.transition(), named, all, firing.ends());
    }

    private static boolean fits(TokenOption option, Set<String> standing) {
        return option.standing.map(standing::equals).orElseGet(() -> standing.containsAll(option.present));
    }

    private String free(Set<String> used, Predicate<Set<String>> where) {
        return at.entrySet().stream()
                .filter(robot -> !used.contains(robot.getKey()) && where.test(robot.getValue()))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("no robot is where the firing needs one: " + at));
    }

    private PlanMarking named(PlanMarking marking) {
        SortedMap<String, SortedMap<String, Integer>> tokens = new TreeMap<>();
        marking.tokens()
                .forEach((place, here) -> here.forEach((token, count) -> {
                    if (!net.isRobot(token)) {
                        tokens.computeIfAbsent(place, p -> new TreeMap<>()).put(token, count);
                    }
                }));
        at.forEach((robot, standing) -> standing.forEach(
                place -> tokens.computeIfAbsent(place, p -> new TreeMap<>()).put(robot, 1)));
        return new PlanMarking(tokens, marking.nobody(), marking.running());
    }
}
