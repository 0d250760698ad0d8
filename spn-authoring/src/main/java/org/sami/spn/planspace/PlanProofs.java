package org.sami.spn.planspace;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import org.sami.petri.query.NetQuery;
import org.sami.petri.structure.StructuralAnswers;
import org.sami.petri.structure.StructuralQueries;
import org.sami.petri.structure.StructureLimits;
import org.sami.spn.plannet.PlanNet;

/**
 * Answers queries of a plan from the structure of its net alone, before its states are searched: those whose answer is that something never happens. Only for nets that follow
 * all that the plan can do, and which are proved to follow every token. A net that follows only whether there are robots is left out, as the sums of its tokens are not those
 * of the plan. For one thread.
 */
final class PlanProofs {
    /** So long structure is tried, for all queries together: most plans have so few states that a search is as fast. */
    private static final Duration MOST_TIME = Duration.ofSeconds(2);

    private final PlanNet net;
    private final StructuralAnswers structure;
    private final StructuralQueries queries;
    private Optional<Boolean> whole = Optional.empty();

    PlanProofs(PlanNet net, BooleanSupplier isCancelled) {
        this.net = net;
        long deadline = System.nanoTime() + MOST_TIME.toNanos();
        structure = new StructuralAnswers(
                net.net(), StructureLimits.USUAL.withCancel(isCancelled).until(deadline, System::nanoTime));
        queries = new StructuralQueries(net.net(), structure);
    }

    /** The answer with its proof; empty where states have to be searched. */
    Optional<StructuralQueries.Answer> answer(NetQuery asked) {
        boolean mayBe = asked instanceof NetQuery.Reachable
                || asked instanceof NetQuery.Invariant
                || asked instanceof NetQuery.Deadlock;
        return mayBe && !net.isPresent() && isWhole() ? queries.answer(asked) : Optional.empty();
    }

    /** Whether it is proved that the net follows all that the plan can do. */
    private boolean isWhole() {
        if (whole.isEmpty()) {
            OptionalLong beyond = net.isPartial() ? OptionalLong.empty() : structure.mostTokens(net.beyond());
            whole = Optional.of(beyond.isPresent() && beyond.getAsLong() == 0);
        }
        return whole.get();
    }
}
