package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.sami.spn.reference.ChildComparison.Compared;

/**
 * Nets that follow sub-missions of plans that make copies of robots, on random small plans: each firing of the engine, of the mission and of its descendants, is one of the net,
 * and each marking that the engine reaches is in the net's graph. More seeds: {@code ./gradlew :spn-core:test --tests '*CopiedChildNetTest' -Pseeds=5000}.
 */
class CopiedChildNetTest {
    private static final long SEEDS = Long.getLong("spn.seeds", 100);
    /** Searches of whole graphs take long: of so many seeds one. */
    private static final long ONE_GRAPH_OF = 5;

    private static final ChildComparison PLANS = new ChildComparison(CopiedChildPlans::project, true);

    @Test
    void theNetDoesWhatTheEngineDoes() {
        AtomicLong ofChildren = new AtomicLong();

        List<String> differences = LongStream.rangeClosed(1, SEEDS)
                .parallel()
                .boxed()
                .flatMap(seed -> PLANS.walks(seed, ofChildren).stream())
                .limit(5)
                .toList();

        assertThat(differences).isEmpty();
        assertThat(ofChildren.get()).isGreaterThan(SEEDS);
    }

    @Test
    void theGraphHasWhatTheEngineReaches() {
        List<Compared> compared = LongStream.rangeClosed(1, SEEDS / ONE_GRAPH_OF)
                .parallel()
                .boxed()
                .flatMap(seed -> PLANS.compare(seed).stream())
                .toList();

        assertThat(compared.stream().map(Compared::difference).filter(text -> !text.isEmpty()))
                .isEmpty();
        assertThat(compared.stream().filter(each -> each.markings() > 3).count())
                .isGreaterThan(SEEDS / ONE_GRAPH_OF / 10);
    }

    /** What the engine does in random sessions on a seed's plan and the net cannot do; empty where it can do all. */
    static Optional<String> difference(long seed) {
        return PLANS.walks(seed, new AtomicLong());
    }
}
