package org.sami.spn.reference;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongFunction;
import java.util.stream.IntStream;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.petri.net.FiringRule;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.TestVocabulary;

/** Compares nets that follow sub-missions with the engine, on random plans in which news of every type, and presses of a button, may come at any time. */
final class ChildComparison {
    private static final int DEPTH = 2;
    private static final int MOST_TRANSITIONS = 3_000;
    private static final int LENGTH = 40;
    private static final int WALKS = 3;
    /** Of a hundred inputs so many are presses of the button, where the plan has it. */
    private static final int PRESSES = 20;

    private static final List<String> ROBOTS = List.of("A", "B");
    private static final SearchBudget SMALL = new SearchBudget(3_000, 256L << 20, Duration.ofMinutes(15));

    private final LongFunction<Project> projects;
    private final boolean withCopies;

    /**
     * Compares some plans.
     *
     * @param projects by their seeds; their transitions wait for {@link ChildPlans#EVENTS}
     * @param withCopies whether plans that make copies of robots are among them: the graphs of their nets are large
     */
    ChildComparison(LongFunction<Project> projects, boolean withCopies) {
        this.projects = projects;
        this.withCopies = withCopies;
    }

    /**
     * What was seen of a seed's plan.
     *
     * @param isExact whether the net leaves nothing open but which news comes
     * @param markings how many markings the engine reaches
     * @param difference empty where there is none
     */
    record Compared(boolean isExact, int markings, String difference) {}

    /** What differs for a seed; empty where nothing does. */
    Optional<String> difference(long seed) {
        return compare(seed)
                .map(Compared::difference)
                .filter(text -> !text.isEmpty())
                .or(() -> walks(seed, new AtomicLong()));
    }

    private Optional<PlanNet> net(long seed) {
        try {
            return Optional.of(PlanNet.of(new PlanNetRequest(
                            projects.apply(seed), TestVocabulary.TEST, "main", ROBOTS, 2, MOST_TRANSITIONS, DEPTH)))
                    .filter(net -> net.followsSubMissions() && (withCopies || !EngineMarkings.makesCopies(net)));
        } catch (PlanNetTooLargeException e) {
            return Optional.empty();
        }
    }

    /** What the engine does in random sessions and the net cannot do. */
    Optional<String> walks(long seed, AtomicLong ofChildren) {
        Optional<PlanNet> net = net(seed);
        if (net.isEmpty()) {
            return Optional.empty();
        }
        Dice dice = new Dice(seed * 31 + 5);
        Optional<String> difference = Optional.empty();
        for (int walk = 0; walk < WALKS && difference.isEmpty(); walk++) {
            difference = walk(net.get(), dice, ofChildren).map(text -> "seed " + seed + ": " + text);
        }
        return difference;
    }

    private static Optional<String> walk(PlanNet net, Dice dice, AtomicLong ofChildren) {
        Engine engine = new Engine(TestVocabulary.TEST, net.request().project());
        EngineState state = engine.newState();
        ROBOTS.forEach(robot -> engine.step(state, 0, new Input.ProxyJoined(robot)));
        FollowedNet followed = new FollowedNet(net, 1);
        boolean hasButton = EngineMarkings.hasButton(net);
        Input input = new Input.StartMission("main", "m", Map.of());
        List<Input> inputs = new ArrayList<>();
        for (int i = 0; i < LENGTH; i++) {
            inputs.add(input);
            for (Effect effect : engine.step(state, 0, input)) {
                String difference = followed.saw(effect);
                if (!difference.isEmpty()) {
                    return Optional.of(inputs + ": " + difference);
                }
            }
            String difference = followed.settle();
            if (!difference.isEmpty()) {
                return Optional.of(inputs + ": " + difference);
            }
            input = hasButton && dice.chance(PRESSES)
                    ? new Input.Interrupt(1, EngineMarkings.BUTTON, dice.some(ROBOTS))
                    : new Input.Received(Occurrence.news(
                            dice.pick(ChildPlans.EVENTS), dice.chance(80) ? dice.some(ROBOTS) : List.of(), Map.of()));
        }
        ofChildren.addAndGet(followed.firingsOfChildren());
        return Optional.empty();
    }

    private static boolean goesOnAfterItsEnd(PlanNet net, ReachabilityGraph graph) {
        return IntStream.range(0, graph.states())
                .mapToObj(graph::marking)
                .filter(marking -> !net.marking(marking).running())
                .anyMatch(marking -> IntStream.range(0, net.net().transitionCount())
                        .anyMatch(t -> FiringRule.isEnabled(net.net(), t, marking)));
    }

    /** The markings of the engine and of the net. */
    Optional<Compared> compare(long seed) {
        Optional<PlanNet> found = net(seed);
        if (found.isEmpty()) {
            return Optional.empty();
        }
        PlanNet net = found.get();
        ReachabilityGraph graph = ReachabilitySearch.explore(net.net(), SearchSettings.within(SMALL));
        if (!graph.isComplete() || graph.mostTokens(net.beyond()) > 0) {
            return Optional.empty();
        }
        if (goesOnAfterItsEnd(net, graph)) {
            return Optional.of(new Compared(false, 0, "seed " + seed + ": something fires after the end"));
        }
        EngineMarkings engine = new EngineMarkings(net, ChildPlans.EVENTS);
        Set<String> less = new TreeSet<>(engine.all(new Dice(seed)));
        Set<String> more = ExactNetTest.markings(net, graph);
        Set<String> onlyEngine = new TreeSet<>(less);
        onlyEngine.removeAll(more);
        if (!onlyEngine.isEmpty()) {
            return Optional.of(
                    new Compared(false, less.size(), "seed " + seed + ": only the engine reaches " + onlyEngine));
        }
        boolean isExact = engine.isWhole()
                && net.open().stream().allMatch(open -> graph.mostTokens(open) == 0)
                && net.abstractions().stream()
                        .allMatch(a -> a.text().contains("\" may come at \"")
                                || a.text().contains("one visit at a time"));
        more.removeAll(less);
        return Optional.of(new Compared(
                isExact,
                less.size(),
                isExact && !more.isEmpty() ? "seed " + seed + ": only the net reaches " + more : ""));
    }
}
