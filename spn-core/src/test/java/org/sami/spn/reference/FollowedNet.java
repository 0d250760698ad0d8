package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.sami.petri.net.FiringRule;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Token;

/** Holds the firings of one mission to the net of its plan: all markings of the net that fit what was seen so far. */
final class FollowedNet {
    private static final int MOST = 3000;

    private final PlanNet plan;
    private final long mission;
    private final FollowedMarking marking = new FollowedMarking();
    private final Map<String, List<Integer>> cases = new HashMap<>();
    private List<int[]> fitting;
    /** The way to each sub-mission, as {@code p1/p2}; empty for the mission itself. */
    private final Map<Long, String> paths = new HashMap<>();

    private Optional<Effect.Fired> last = Optional.empty();
    private int ofChildren;
    private int firings;
    private boolean isLost;

    FollowedNet(PlanNet plan, long mission) {
        this.plan = plan;
        this.mission = mission;
        paths.put(mission, "");
        fitting = List.of(plan.net().initialMarking());
        for (int t = 0; t < plan.net().transitionCount(); t++) {
            cases.computeIfAbsent(plan.firing(t).transition(), id -> new ArrayList<>())
                    .add(t);
        }
    }

    int firings() {
        return firings;
    }

    /** How many firings of sub-missions the net followed. */
    int firingsOfChildren() {
        return ofChildren;
    }

    /** Whether it is a sub-mission of the mission. */
    boolean isChild(long other) {
        return other != mission && paths.containsKey(other);
    }

    /** Takes an effect in; what differs, empty where the net can do it. */
    String saw(Effect effect) {
        boolean isNext = (effect instanceof Effect.Fired fired && isFollowed(fired.mission()))
                || (effect instanceof Effect.MissionEnded ended && ended.mission() == mission);
        String difference = isNext ? settle() : "";
        marking.accept(effect);
        if (effect instanceof Effect.MissionStarted child && paths.containsKey(child.parent())) {
            paths.put(child.mission(), path(child.parent()) + child.place());
        }
        if (effect instanceof Effect.Fired fired && isFollowed(fired.mission()) && !isLost) {
            last = Optional.of(fired);
        }
        return difference;
    }

    /** The way in front of a place of a mission. */
    private String path(long of) {
        String path = paths.getOrDefault(of, "");
        return path.isEmpty() ? "" : path + "/";
    }

    private boolean isFollowed(long fired) {
        return fired == mission || (plan.followsSubMissions() && paths.containsKey(fired));
    }

    /** Compares the marking after the latest firing, of which all was seen; what differs. */
    String settle() {
        if (last.isEmpty()) {
            return "";
        }
        Effect.Fired fired = last.get();
        last = Optional.empty();
        SortedMap<String, SortedMap<String, Integer>> seen = seen(mission, "");
        String path = path(fired.mission());
        SortedMap<String, SortedMap<String, Integer>> inside = path.isEmpty() ? seen : seen(fired.mission(), path);
        if (seen.values().stream().anyMatch(here -> here.containsKey("?"))) {
            isLost = true;
            return "";
        }
        Map<String, int[]> next = new LinkedHashMap<>();
        boolean mayBeMore = false;
        for (int[] from : fitting) {
            if (!path.isEmpty() && plan.isOpen(from, paths.getOrDefault(fired.mission(), ""))) {
                next.put(Arrays.toString(from), from);
                continue;
            }
            for (int t : cases.getOrDefault(path + fired.transition(), List.of())) {
                if (FiringRule.isEnabled(plan.net(), t, from)) {
                    int[] to = FiringRule.fire(plan.net(), t, from);
                    if (to[plan.beyond()] > 0) {
                        mayBeMore = true;
                    } else if (plan.marking(to).tokens().equals(seen)
                            && (path.isEmpty() || plan.inside(to, path).equals(inside))) {
                        next.put(Arrays.toString(to), to);
                    }
                }
            }
        }
        if (next.isEmpty()) {
            isLost = true;
            return mayBeMore
                    ? "" // there were more tokens at once than the net follows
                    : path + fired.transition() + " came to " + inside + " in " + seen + ", the net not from "
                            + plan.marking(fitting.get(0)).tokens() + " "
                            + plan.marking(fitting.get(0)).nobody() + " moves "
                            + fired;
        }
        fitting = List.copyOf(next.values());
        isLost = fitting.size() > MOST;
        firings++;
        ofChildren += path.isEmpty() ? 0 : 1;
        return "";
    }

    /** Only that a named token is there counts, not how many copies are. */
    private SortedMap<String, SortedMap<String, Integer>> seen(long of, String path) {
        SortedMap<String, SortedMap<String, Integer>> seen = new TreeMap<>();
        marking.marking(of)
                .forEach((place, tokens) -> tokens.forEach(token -> {
                    String label = label(token);
                    seen.computeIfAbsent(path + place, p -> new TreeMap<>())
                            .merge(label, 1, label.equals("generic") ? Integer::sum : Math::max);
                }));
        return seen;
    }

    private String label(Token token) {
        if (token instanceof Token.Proxy robot) {
            return plan.request().robots().contains(robot.proxy()) ? robot.proxy() : "?";
        }
        return token instanceof Token.Task task
                ? task.task().mission() == mission ? "#" + task.task().name() : "?"
                : "generic";
    }
}
