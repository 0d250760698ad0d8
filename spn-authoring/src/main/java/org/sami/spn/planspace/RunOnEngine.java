package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.MarkingTest;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.stepping.MomentKey;
import org.sami.spn.stepping.NextStep;
import org.sami.spn.stepping.NextSteps;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.TakenStep;

/**
 * Takes a run of a plan's net on the engine itself. A net can do more than its plan, so only a run that the engine takes is known to be one of the plan. The search
 * prefers steps by which the engine fires what the run fires; it may fire more, and in another order, as long as the net does so with it and comes to a marking that
 * was asked for. That no steps are found is no proof that there are none: values are samples. For one thread.
 */
final class RunOnEngine {
    private static final List<Integer> LOCATIONS = List.of(1, 3, 5, 0);

    private final PlanNet net;
    private final int mostSteps;
    private final BooleanSupplier isCancelled;
    private int tried;
    private int arrivals;

    /**
     * Searches for a net.
     *
     * @param mostSteps how many steps of the engine are tried for one run
     */
    RunOnEngine(PlanNet net, int mostSteps, BooleanSupplier isCancelled) {
        this.net = net;
        this.mostSteps = mostSteps;
        this.isCancelled = isCancelled;
    }

    private record Way(Stepper at, FollowedRun run, List<TestStep> steps, int arrival) {
        int distance() {
            return run.left().size() + 2 * run.more();
        }
    }

    private record Known(MomentKey moment, FollowedRun run) {}

    /**
     * The steps by which the engine comes to where the run ends.
     *
     * @param goal what is asked for, of markings of the net; the end of the run fulfils it
     * @param name of the test case
     */
    Optional<TestCase> steps(FiringSequence run, MarkingTest goal, String name) {
        List<String> robots = net.request().robots();
        Stepper start;
        try {
            start = Stepper.start(
                    new Engine(net.request().vocabulary(), net.request().project()),
                    net.request().plan(),
                    net.request().plan(),
                    robots);
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        }
        int[] initial = net.net().initialMarking();
        Optional<FollowedRun> first = FollowedRun.at(initial, run.transitions(), goal.test(initial))
                .after(net, goal, new FollowedMarking(), start.startEffects(), start.mission());
        return first.flatMap(begun -> search(new Way(start.branch(), begun, List.of(), 0), goal))
                .map(way -> new TestCase(name, robots, way.steps()));
    }

    private Optional<Way> search(Way first, MarkingTest goal) {
        tried = 0;
        arrivals = 0;
        Set<Known> known = new HashSet<>(List.of(new Known(first.at().key(), first.run())));
        PriorityQueue<Way> open =
                new PriorityQueue<>(Comparator.comparingInt(Way::distance).thenComparingInt(Way::arrival));
        open.add(first);
        while (!open.isEmpty() && tried < mostSteps && !isCancelled.getAsBoolean()) {
            Way way = open.poll();
            if (way.run().isThere()) {
                return Optional.of(way);
            }
            if (way.at().outcome().isEmpty()) {
                NextSteps.of(way.at(), LOCATIONS).steps().stream()
                        .flatMap(step -> behind(way, step, goal).stream())
                        .filter(next -> known.add(new Known(next.at().key(), next.run())))
                        .forEach(open::add);
            }
        }
        return Optional.empty();
    }

    private Optional<Way> behind(Way way, NextStep step, MarkingTest goal) {
        tried++;
        Stepper at = way.at().branch();
        FollowedMarking before = new FollowedMarking();
        at.view().markingAsEffects().forEach(before);
        TakenStep taken = at.take(step.step());
        if (taken.refusal().isPresent()) {
            return Optional.empty();
        }
        List<TestStep> steps = new ArrayList<>(way.steps());
        steps.add(step.step());
        return way.run()
                .after(net, goal, before, taken.effects(), at.mission())
                .map(run -> new Way(at.branch(), run, steps, ++arrivals));
    }
}
