package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.sami.petri.graph.MarkingTest;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Token;

/**
 * How far the engine has come with a run of a plan's net: the net fires along with the engine, and each marking is held to the engine's. Immutable.
 *
 * @param marking of the net, where the engine stands
 * @param left transitions of the net that the run fires and the engine has not, in the run's order
 * @param more how many firings the engine has taken that are none of the run's
 * @param isThere whether a marking that was asked for has been passed
 */
record FollowedRun(List<Integer> marking, List<Integer> left, int more, boolean isThere) {
    FollowedRun {
        marking = List.copyOf(marking);
        left = List.copyOf(left);
    }

    static FollowedRun at(int[] marking, List<Integer> run, boolean isThere) {
        return new FollowedRun(listed(marking), run, 0, isThere);
    }

    private static List<Integer> listed(int[] marking) {
        List<Integer> list = new ArrayList<>(marking.length);
        for (int count : marking) {
            list.add(count);
        }
        return list;
    }

    /**
     * Follows what one step of the engine did.
     *
     * @param before the engine's markings before the step; takes the effects in
     * @param mission the one that the net stands for
     * @return empty where the net does not do that
     */
    Optional<FollowedRun> after(
            PlanNet net, MarkingTest goal, FollowedMarking before, List<Effect> effects, long mission) {
        Optional<FollowedRun> run = Optional.of(this);
        Optional<String> fired = Optional.empty();
        for (Effect effect : effects) {
            boolean fires = effect instanceof Effect.Fired firing && firing.mission() == mission;
            boolean ends = effect instanceof Effect.MissionEnded end && end.mission() == mission;
            if ((fires || ends) && fired.isPresent()) {
                run = run.get().fired(net, goal, fired.get(), seen(net, before, mission));
                fired = Optional.empty();
                if (run.isEmpty()) {
                    return run;
                }
            }
            before.accept(effect);
            if (effect instanceof Effect.Fired firing && fires) {
                fired = Optional.of(firing.transition());
            }
        }
        return fired.isPresent() ? run.get().fired(net, goal, fired.get(), seen(net, before, mission)) : run;
    }

    private Optional<FollowedRun> fired(
            PlanNet net, MarkingTest goal, String transition, SortedMap<String, SortedMap<String, Integer>> seen) {
        int[] from = marking.stream().mapToInt(Integer::intValue).toArray();
        for (int i = 0; i < left.size(); i++) {
            if (fits(net, left.get(i), transition, from, seen)) {
                List<Integer> rest = new ArrayList<>(left);
                rest.remove(i);
                return Optional.of(behind(net, goal, left.get(i), from, rest, more));
            }
        }
        for (int t = 0; t < net.net().transitionCount(); t++) {
            if (fits(net, t, transition, from, seen)) {
                return Optional.of(behind(net, goal, t, from, left, more + 1));
            }
        }
        return Optional.empty();
    }

    private static boolean fits(
            PlanNet net, int t, String transition, int[] from, SortedMap<String, SortedMap<String, Integer>> seen) {
        PetriNet petri = net.net();
        return net.firing(t).transition().equals(transition)
                && FiringRule.isEnabled(petri, t, from)
                && net.marking(FiringRule.fire(petri, t, from)).tokens().equals(seen);
    }

    private FollowedRun behind(PlanNet net, MarkingTest goal, int t, int[] from, List<Integer> rest, int others) {
        int[] to = FiringRule.fire(net.net(), t, from);
        return new FollowedRun(listed(to), rest, others, isThere || goal.test(to));
    }

    /** The engine's tokens as the net counts them: of a token with a name of its own only that it is there. */
    private static SortedMap<String, SortedMap<String, Integer>> seen(
            PlanNet net, FollowedMarking engine, long mission) {
        SortedMap<String, SortedMap<String, Integer>> seen = new TreeMap<>();
        engine.marking(mission)
                .forEach((place, tokens) -> tokens.forEach(token -> {
                    boolean isNamed =
                            !(token instanceof Token.Generic || (net.isCounted() && token instanceof Token.Proxy));
                    seen.computeIfAbsent(place, p -> new TreeMap<>())
                            .merge(label(net, token, mission), 1, isNamed ? Math::max : Integer::sum);
                }));
        return seen;
    }

    /** A token that the net does not know has a label that fits none of its tokens. */
    private static String label(PlanNet net, Token token, long mission) {
        if (token instanceof Token.Proxy robot) {
            return !net.request().robots().contains(robot.proxy())
                    ? "?"
                    : net.isCounted() ? PlanNet.ROBOTS : robot.proxy();
        }
        return token instanceof Token.Task task
                ? task.task().mission() == mission ? "#" + task.task().name() : "?"
                : "generic";
    }
}
