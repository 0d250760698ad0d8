package org.sami.spn.analysis.space;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.stepping.MomentKey;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.NextSteps;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;

/**
 * The states that a plan reaches by the steps of {@link NextSteps}, nearest first, until there is none left, the bound is met or somebody
 * stops it. States that go on alike ({@link MomentKey}) are one. The same request gives the same exploration.
 */
final class Exploration {
    private static final int TELL_EVERY = 64;

    private final List<Node> nodes = new ArrayList<>();
    private final Set<String> visited = new LinkedHashSet<>();
    private final Set<String> fired = new LinkedHashSet<>();
    private int looked;

    /** A state that was reached. */
    static final class Node {
        private final List<Node> before = new ArrayList<>(2);
        private final Map<String, List<Token>> marking;
        private final Optional<Outcome> outcome;
        private final Optional<Node> parent;
        private final Optional<TestStep> step;
        private final int steps;
        private Optional<Stepper> stepper;

        private Node(Stepper stepper, Optional<Node> parent, Optional<TestStep> step) {
            this.stepper = Optional.of(stepper);
            this.parent = parent;
            this.step = step;
            this.steps = parent.map(before -> before.steps + 1).orElse(0);
            this.outcome = stepper.outcome();
            this.marking = stepper.view()
                    .mission(stepper.mission())
                    .map(MissionView::marking)
                    .orElse(Map.of());
        }

        /** Whether all that is tried here was tried. */
        boolean isLookedAt() {
            return stepper.isEmpty();
        }

        boolean isOver() {
            return outcome.isPresent() && outcome.get() != Outcome.HALTED;
        }

        boolean isHalted() {
            return outcome.isPresent() && outcome.get() == Outcome.HALTED;
        }

        Map<String, List<Token>> marking() {
            return marking;
        }

        List<Node> before() {
            return before;
        }

        int steps() {
            return steps;
        }

        /** The shortest run that leads here. */
        TestCase witness(String name, List<String> robots) {
            List<TestStep> way = new ArrayList<>();
            for (Node node = this; node.step.isPresent(); node = node.parent.orElseThrow()) {
                way.add(0, node.step.get());
            }
            return new TestCase(name, robots, way);
        }
    }

    private Exploration() {}

    static Exploration of(DeepRequest request, SearchWatch watch) {
        Exploration exploration = new Exploration();
        Stepper start = Stepper.start(
                new Engine(request.vocabulary(), request.project()), request.plan(), request.plan(), request.robots());
        exploration.run(start, request.mostStates(), watch);
        return exploration;
    }

    private void run(Stepper start, int mostStates, SearchWatch watch) {
        Map<MomentKey, Node> known = new LinkedHashMap<>();
        Node first = new Node(start, Optional.empty(), Optional.empty());
        known.put(start.key(), first);
        nodes.add(first);
        saw(start, start.startEffects());
        while (looked < nodes.size() && looked < mostStates && !watch.isCancelled()) {
            Node node = nodes.get(looked++);
            if (!node.isOver() && !node.isHalted()) {
                expand(node, node.stepper.orElseThrow(), known);
            }
            node.stepper = Optional.empty();
            if (looked % TELL_EVERY == 0) {
                watch.looked(looked, nodes.size() - looked);
            }
        }
        watch.looked(looked, nodes.size() - looked);
    }

    private void expand(Node node, Stepper at, Map<MomentKey, Node> known) {
        for (NextStep next : NextSteps.of(at, NextSteps.LOCATIONS).steps()) {
            Stepper stepper = at.branch();
            TakenStep taken = stepper.take(next.step());
            if (taken.refusal().isPresent()) {
                continue;
            }
            saw(stepper, taken.effects());
            MomentKey key = stepper.key();
            Node reached = known.get(key);
            if (reached == null) {
                reached = new Node(stepper, Optional.of(node), Optional.of(next.step()));
                known.put(key, reached);
                nodes.add(reached);
            }
            reached.before.add(node);
        }
    }

    private void saw(Stepper stepper, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Entered e && e.mission() == stepper.mission()) {
                visited.add(e.place());
            } else if (effect instanceof Effect.Fired e && e.mission() == stepper.mission()) {
                fired.add(e.transition());
            }
        }
    }

    /** The states, those of the shortest runs first. */
    List<Node> nodes() {
        return nodes;
    }

    /** Places of the plan that somebody or nobody entered. */
    Set<String> visited() {
        return visited;
    }

    /** Transitions of the plan that fired. */
    Set<String> fired() {
        return fired;
    }

    int looked() {
        return looked;
    }

    /** Whether every state that was reached was looked at: there are no others by these steps. */
    boolean isComplete() {
        return looked == nodes.size();
    }
}
