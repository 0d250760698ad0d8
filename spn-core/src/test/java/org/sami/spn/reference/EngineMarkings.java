package org.sami.spn.reference;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.StateKey;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;

/**
 * The markings to which the engine brings the mission of a small plan, after each firing, where news of every type, and presses of a button that the plan has, may come at any time and name
 * any of the robots. One state of each marking is followed, by news that lets a transition fire at once; random runs have news that waits as well.
 */
final class EngineMarkings {
    private static final int MOST_MARKINGS = 3_000;
    private static final int WALKS = 10;
    private static final int LENGTH = 30;

    /** What is written on the button of plans that have one. */
    static final String BUTTON = "stop";

    private final Engine engine;
    private final PlanNet net;
    private final List<Input> news = new ArrayList<>();
    private final Set<String> all = new TreeSet<>();
    /** Whether the net counts how often a robot stands in a place; else it follows whether it does. */
    private final boolean countsCopies;

    private boolean isWhole;

    EngineMarkings(PlanNet net, List<String> events) {
        this.net = net;
        engine = new Engine(net.request().vocabulary(), net.request().project());
        for (String event : events) {
            for (int names = 0; names < 1 << net.request().robots().size(); names++) {
                news.add(new Input.Received(Occurrence.news(event, named(names), Map.of())));
            }
        }
        for (int names = 0;
                hasButton(net) && names < 1 << net.request().robots().size();
                names++) {
            news.add(new Input.Interrupt(1, BUTTON, named(names)));
        }
        countsCopies = net.abstractions().stream().noneMatch(a -> a.text().contains("copies of"));
    }

    /** Whether the plan itself makes copies of robots that the net does not count. */
    static boolean makesCopies(PlanNet net) {
        return net.abstractions().stream().anyMatch(a -> a.text().startsWith("the plan can make copies of"));
    }

    /** Whether the plan has a transition that waits for the button. */
    static boolean hasButton(PlanNet net) {
        return net.request().project().plan(net.request().plan()).stream()
                .flatMap(plan -> plan.transitions().stream())
                .flatMap(t -> t.inputs().stream())
                .anyMatch(input -> input.type().equals("Interrupt"));
    }

    private List<String> named(int bits) {
        List<String> named = new ArrayList<>();
        for (int i = 0; i < net.request().robots().size(); i++) {
            if ((bits >> i & 1) == 1) {
                named.add(net.request().robots().get(i));
            }
        }
        return named;
    }

    /** The markings in words; of more than some thousand only so many. */
    Set<String> all(Dice dice) {
        EngineState first = engine.newState();
        net.request().robots().forEach(robot -> engine.step(first, 0, new Input.ProxyJoined(robot)));
        step(first, new Input.StartMission(net.request().plan(), "m", Map.of()));
        Set<Object> known = new HashSet<>(Set.of(key(first)));
        Deque<EngineState> open = new ArrayDeque<>(List.of(first));
        while (!open.isEmpty() && known.size() <= MOST_MARKINGS) {
            EngineState state = open.remove();
            for (Input input : news) {
                EngineState next = state.copy();
                if (step(next, input) && known.add(key(next))) {
                    open.add(next);
                }
            }
        }
        isWhole = open.isEmpty();
        for (int walk = 0; walk < WALKS; walk++) {
            EngineState state = first.copy();
            for (int i = 0; i < LENGTH; i++) {
                step(state, dice.pick(news));
            }
        }
        return all;
    }

    /** Takes an input and keeps the marking after each firing; whether something fired. */
    private boolean step(EngineState state, Input input) {
        FollowedMarking marking = new FollowedMarking();
        engine.view(state).markingAsEffects().forEach(marking);
        boolean hasFired = false;
        for (Effect effect : engine.step(state, 0, input)) {
            if (effect instanceof Effect.Fired || effect instanceof Effect.MissionEnded) {
                keep(marking);
            }
            marking.accept(effect);
            hasFired |= effect instanceof Effect.Fired;
            if (effect instanceof Effect.MissionEnded) {
                return true;
            }
        }
        if (input instanceof Input.StartMission || hasFired) {
            keep(marking);
        }
        return hasFired;
    }

    /** Whether all that news brings about at once was followed. */
    boolean isWhole() {
        return isWhole;
    }

    /** One state of each marking; where sub-missions run, what they brought back counts as well. */
    private Object key(EngineState state) {
        if (net.followsSubMissions()) {
            return StateKey.of(state);
        }
        FollowedMarking marking = new FollowedMarking();
        engine.view(state).markingAsEffects().forEach(marking);
        return words(marking, marking.missions());
    }

    private void keep(FollowedMarking marking) {
        all.add(words(marking, net.followsSubMissions() ? roots(marking) : marking.missions()));
    }

    private static List<Long> roots(FollowedMarking marking) {
        return marking.missions().stream()
                .filter(mission -> marking.parent(mission).isEmpty())
                .toList();
    }

    private String words(FollowedMarking marking, List<Long> missions) {
        List<String> words = new ArrayList<>();
        missions.forEach(mission -> {
            SortedMap<String, SortedMap<String, Integer>> seen = new TreeMap<>();
            marking.marking(mission)
                    .forEach((place, tokens) -> tokens.forEach(token -> {
                        SortedMap<String, Integer> here = seen.computeIfAbsent(place, p -> new TreeMap<>());
                        if (token instanceof Token.Proxy robot) {
                            here.merge(robot.proxy(), 1, countsCopies ? Integer::sum : Math::max);
                        } else {
                            here.merge("generic", 1, Integer::sum);
                        }
                    }));
            words.add(seen.toString());
        });
        return String.join(" ", words);
    }
}
