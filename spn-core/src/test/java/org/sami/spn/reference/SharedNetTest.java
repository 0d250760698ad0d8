package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.sami.spn.reference.ChildComparison.Compared;

/**
 * Nets that follow shared sub-missions, on random small plans in which one event may come to several transitions: each firing of the engine, of the mission and of its
 * descendants, is one of the net, and each marking that the engine reaches is in the net's graph. More seeds: {@code ./gradlew :spn-core:test --tests '*SharedNetTest'
 * -Pseeds=5000}.
 */
class SharedNetTest {
    private static final long SEEDS = Long.getLong("spn.seeds", 250);
    private static final ChildComparison PLANS = new ChildComparison(SharedPlans::project, true);

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
        List<Compared> compared = LongStream.rangeClosed(1, SEEDS)
                .parallel()
                .boxed()
                .flatMap(seed -> PLANS.compare(seed).stream())
                .toList();

        assertThat(compared.stream().map(Compared::difference).filter(text -> !text.isEmpty()))
                .isEmpty();
        assertThat(compared.stream().filter(each -> each.markings() > 3).count())
                .isGreaterThan(SEEDS / 10);
    }

    /** What differs for a seed; empty where nothing does. */
    static Optional<String> difference(long seed) {
        return PLANS.difference(seed);
    }
}
