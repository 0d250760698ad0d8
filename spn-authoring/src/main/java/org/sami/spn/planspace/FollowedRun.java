package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.sami.petri.graph.MarkingTest;
import org.sami.petri.net.FiringRule;
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
        Optional<Firing> fired = Optional.empty();
        for (Effect effect : effects) {
            Optional<String> path = effect instanceof Effect.Fired firing
                    ? path(net, before, firing.mission(), mission)
                    : Optional.empty();
            boolean ends = effect instanceof Effect.MissionEnded end && end.mission() == mission;
            if ((path.isPresent() || ends) && fired.isPresent()) {
                run = run.get().fired(net, goal, fired.get(), before, mission);
                fired = Optional.empty();
                if (run.isEmpty()) {
                    return run;
                }
            }
            before.accept(effect);
            if (effect instanceof Effect.Fired firing && path.isPresent()) {
                fired = Optional.of(new Firing(firing.mission(), path.get(), firing.transition()));
            }
        }
        return fired.isPresent() ? run.get().fired(net, goal, fired.get(), before, mission) : run;
    }

    /**
     * A firing of the engine.
     *
     * @param path to the places of the sub-mission that fires; empty for the mission itself
     */
    private record Firing(long mission, String path, String transition) {}

    /** The path to the places of a mission; empty where the net does not follow it. */
    private static Optional<String> path(PlanNet net, FollowedMarking engine, long of, long root) {
        StringBuilder path = new StringBuilder();
        long at = of;
        while (at != root) {
            OptionalLong parent = engine.parent(at);
            if (parent.isEmpty() || !net.followsSubMissions()) {
                return Optional.empty();
            }
            path.insert(0, engine.parentPlace(at) + "/");
            at = parent.getAsLong();
        }
        return Optional.of(path.toString());
    }

    private Optional<FollowedRun> fired(
            PlanNet net, MarkingTest goal, Firing fired, FollowedMarking engine, long mission) {
        int[] from = marking.stream().mapToInt(Integer::intValue).toArray();
        String path = fired.path();
        if (!path.isEmpty() && net.isOpen(from, path.substring(0, path.length() - 1))) {
            return Optional.of(this);
        }
        SortedMap<String, SortedMap<String, Integer>> seen = seen(net, engine, mission, "");
        SortedMap<String, SortedMap<String, Integer>> inside = seen(net, engine, fired.mission(), path);
        Predicate<Integer> fits = t -> net.firing(t).transition().equals(path + fired.transition())
                && FiringRule.isEnabled(net.net(), t, from)
                && isAt(net, FiringRule.fire(net.net(), t, from), seen, path, inside);
        for (int i = 0; i < left.size(); i++) {
            if (fits.test(left.get(i))) {
                List<Integer> rest = new ArrayList<>(left);
                rest.remove(i);
                return Optional.of(behind(net, goal, left.get(i), from, rest, more));
            }
        }
        for (int t = 0; t < net.net().transitionCount(); t++) {
            if (fits.test(t)) {
                return Optional.of(behind(net, goal, t, from, left, more + 1));
            }
        }
        return Optional.empty();
    }

    private static boolean isAt(
            PlanNet net,
            int[] to,
            SortedMap<String, SortedMap<String, Integer>> seen,
            String path,
            SortedMap<String, SortedMap<String, Integer>> inside) {
        return net.marking(to).tokens().equals(seen)
                && (path.isEmpty() || net.inside(to, path).equals(inside));
    }

    private FollowedRun behind(PlanNet net, MarkingTest goal, int t, int[] from, List<Integer> rest, int others) {
        int[] to = FiringRule.fire(net.net(), t, from);
        return new FollowedRun(listed(to), rest, others, isThere || goal.test(to));
    }

    /** The engine's tokens as the net counts them: of a token with a name of its own only that it is there. */
    private static SortedMap<String, SortedMap<String, Integer>> seen(
            PlanNet net, FollowedMarking engine, long mission, String path) {
        SortedMap<String, SortedMap<String, Integer>> seen = new TreeMap<>();
        engine.marking(mission)
                .forEach((place, tokens) -> tokens.forEach(token -> {
                    boolean isNamed =
                            !(token instanceof Token.Generic || (net.isCounted() && token instanceof Token.Proxy));
                    seen.computeIfAbsent(path + place, p -> new TreeMap<>())
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
