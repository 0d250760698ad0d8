package org.sami.spn.statespace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.MomentKey;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.Stepper;

/** A state that was reached. */
final class Node {
    private final List<Edge> before = new ArrayList<>(2);
    private final MomentKey key;
    private final Optional<String> dropped;
    private final List<String> withRobots;
    private final List<String> marked;
    private final Map<String, Integer> counts;
    private final long nowMillis;
    private final List<Long> dueMillis;
    private final Optional<Outcome> outcome;
    private Optional<Edge> first;
    private int steps;
    private Optional<Stepper> stepper;
    private boolean looked;
    private boolean unlooked;

    /** A step that leads from one state to another. */
    record Edge(Node from, NextStep step) {}

    /**
     * A state.
     *
     * @param first the step that led here; empty for the start
     * @param shared gives equal texts as one object
     */
    Node(Stepper stepper, Optional<Edge> first, UnaryOperator<String> shared) {
        this.first = first;
        first.ifPresent(before::add);
        steps = first.map(edge -> edge.from().steps + 1).orElse(0);
        key = stepper.key();
        dropped = first.flatMap(edge ->
                edge.step().step() instanceof TestStep.Drop drop ? Optional.of(drop.proxy()) : edge.from().dropped);
        withRobots = dropped.isEmpty() ? List.of() : withRobots(stepper);
        outcome = stepper.outcome();
        Optional<MissionView> mission = stepper.view().mission(stepper.mission());
        marked = mission.map(view -> List.copyOf(view.marking().keySet())).orElse(List.of());
        nowMillis = stepper.nowMillis();
        dueMillis = stepper.view().dueMillis();
        counts = outcome.isPresent() ? Map.of() : counts(stepper.view(), shared);
        this.stepper = outcome.isPresent() ? Optional.empty() : Optional.of(stepper);
    }

    /** How many of each token stand in each place, and how often nobody entered one who was asked for something. */
    private static Map<String, Integer> counts(EngineView view, UnaryOperator<String> shared) {
        Map<String, Integer> counts = new HashMap<>();
        for (MissionView mission : view.missions()) {
            mission.marking()
                    .forEach((place, tokens) -> tokens.forEach(token -> counts.merge(
                            shared.apply(place + " in " + mission.plan() + ": " + token), 1, Integer::sum)));
        }
        view.openActivations().stream()
                .filter(asked -> asked.tokens().isEmpty())
                .forEach(asked -> counts.merge(
                        shared.apply(asked.place() + " in " + asked.plan() + ": nobody"), 1, Integer::sum));
        return Map.copyOf(counts);
    }

    private static List<String> withRobots(Stepper stepper) {
        return stepper.view().mission(stepper.mission()).stream()
                .flatMap(mission -> mission.marking().entrySet().stream())
                .filter(place -> place.getValue().stream().anyMatch(Token.Proxy.class::isInstance))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** The robot that was dropped on the way here. */
    Optional<String> dropped() {
        return dropped;
    }

    /** Ids of the places in which robots stand; only where one was dropped. */
    List<String> withRobots() {
        return withRobots;
    }

    /** A stepper that stands here and came by the witness. */
    Stepper replayed(Stepper start) {
        Stepper at = start.fork();
        way().forEach(at::take);
        return at;
    }

    MomentKey key() {
        return key;
    }

    /** Whether all that is tried here was tried. */
    boolean isLookedAt() {
        return looked && !unlooked;
    }

    /** Whether its turn was. */
    boolean wasLookedAt() {
        return looked;
    }

    /** Notes that something could happen here which was not tried. */
    void setUnlooked() {
        unlooked = true;
    }

    boolean isOver() {
        return outcome.isPresent() && outcome.get() != Outcome.HALTED;
    }

    boolean isHalted() {
        return outcome.isPresent() && outcome.get() == Outcome.HALTED;
    }

    /** Ids of the places in which tokens stand. */
    List<String> marked() {
        return marked;
    }

    Map<String, Integer> counts() {
        return counts;
    }

    /** Whether time has passed since an earlier state on the way here, and a timer of then runs still: what goes on so ends with it. */
    boolean isTimedSince(Node earlier) {
        return nowMillis > earlier.nowMillis && earlier.dueMillis.stream().anyMatch(dueMillis::contains);
    }

    /** All steps that lead here. */
    List<Edge> before() {
        return before;
    }

    /**
     * Notes another step that leads here. A shorter way is that of the witness, where it leads to this very state: to one that is only like it
     * others would go on.
     */
    void reached(Edge edge, Stepper there) {
        before.add(edge);
        if (edge.from().steps + 1 < steps && there.key().equals(key)) {
            first = Optional.of(edge);
            steps = edge.from().steps + 1;
        }
    }

    /** The step by which the witness comes here; empty for the start. */
    Optional<Edge> first() {
        return first;
    }

    int steps() {
        return way().size();
    }

    /** The stepper that stands here, while it is to be looked at. */
    Optional<Stepper> stepper() {
        return stepper;
    }

    /** Notes that it was looked at, and gives the stepper up. */
    void setLooked() {
        looked = true;
        stepper = Optional.empty();
    }

    private List<TestStep> way() {
        List<TestStep> way = new ArrayList<>();
        for (Optional<Edge> edge = first; edge.isPresent(); edge = edge.get().from().first) {
            way.add(0, edge.get().step().step());
        }
        return way;
    }

    /** A run that leads here, the shortest as far as that is known. */
    TestCase witness(String name, List<String> robots) {
        return new TestCase(name, robots, way());
    }

    /** A run that leads here and takes one step more. */
    TestCase witness(String name, List<String> robots, NextStep last) {
        List<TestStep> way = way();
        way.add(last.step());
        return new TestCase(name, robots, way);
    }

    @Override
    public String toString() {
        return marked.stream().collect(Collectors.joining(", ", "[", "]"));
    }
}
