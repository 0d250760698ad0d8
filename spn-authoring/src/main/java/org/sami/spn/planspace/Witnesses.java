package org.sami.spn.planspace;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.MarkingTest;
import org.sami.petri.query.NetQuery;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.TestCase;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetFiring;
import org.sami.spn.plannet.PlanRun;

/** Runs of a plan's net in the words of the plan, taken on the engine where it does the same. */
final class Witnesses {
    /** No more steps of the engine are tried for one run: some seconds at most. */
    private static final int MOST_STEPS = 20_000;

    private final PlanNet net;
    private final RunOnEngine engine;

    /**
     * Runs of a net.
     *
     * @param mostSteps how many steps of the engine are tried for one run, as far as that takes seconds
     */
    Witnesses(PlanNet net, int mostSteps, BooleanSupplier isCancelled) {
        this.net = net;
        engine = new RunOnEngine(net, Math.min(MOST_STEPS, mostSteps), isCancelled);
    }

    /** The run that shows the answer to a query. */
    PlanWitness of(FiringSequence run, PlanQuery query, NetQuery asked) {
        Optional<TestCase> steps = engine.steps(run, goal(asked, run), query.name());
        PlanRun named = net.run(run);
        List<PlanNetFiring> firings = named.firings();
        List<PlanMarking> markings = named.markings();
        PlanStateWords words = new PlanStateWords(net);
        return new PlanWitness(
                firings,
                markings,
                firings.stream().map(words::moves).toList(),
                words.marked(markings.get(markings.size() - 1)),
                steps);
    }

    /** What the engine has to come to: what was asked for; where that is about all that follows, the end of the run itself. */
    private MarkingTest goal(NetQuery asked, FiringSequence run) {
        if (asked instanceof NetQuery.Reachable reachable) {
            return reachable.condition();
        } else if (asked instanceof NetQuery.Invariant invariant) {
            return marking -> !invariant.condition().test(marking);
        }
        int[] end = run.replay(net.net());
        return marking -> Arrays.equals(marking, end);
    }
}
