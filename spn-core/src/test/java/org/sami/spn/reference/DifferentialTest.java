package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.testing.TestVocabulary;

/**
 * The engine and the interpreter agree after every input of thousands of random sessions on random plans. More seeds:
 * {@code ./gradlew :spn-core:test --tests '*DifferentialTest' -Pseeds=50000 -PfirstSeed=1}.
 */
class DifferentialTest {
    private static final long FIRST_SEED = Long.getLong("spn.firstSeed", 1);
    private static final long SEEDS = Long.getLong("spn.seeds", 3000);

    /** How often a build exercises each rule at least, and the sessions that takes. */
    private static final long LEAST = 200;

    private static final long ENOUGH_SEEDS = 3000;

    private static Subject engine(org.sami.spn.model.Project project) {
        return new EngineSubject(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
    }

    @Test
    void engineAndInterpreterAgreeOnRandomPlans() {
        List<String> disagreements = new ArrayList<>();
        Coverage coverage = new Coverage();
        for (long seed = FIRST_SEED; seed < FIRST_SEED + SEEDS && disagreements.size() < 3; seed++) {
            Differential.explore(seed, Scenario.LENGTH, DifferentialTest::engine, coverage)
                    .ifPresent(d -> disagreements.add(shrunk(d)));
        }

        assertThat(disagreements).as("Disagreements").isEmpty();
        assertThat(coverage.below(SEEDS < ENOUGH_SEEDS ? 0 : LEAST))
                .as("Rules that the sessions exercised less than %d times", LEAST)
                .isEmpty();
    }

    @Test
    void engineAndInterpreterAgreeOnLongSessions() {
        List<String> disagreements = new ArrayList<>();
        for (long seed = FIRST_SEED; seed < FIRST_SEED + SEEDS / 30 && disagreements.size() < 3; seed++) {
            Differential.explore(1_000_000 + seed, 150, DifferentialTest::engine)
                    .ifPresent(d -> disagreements.add(shrunk(d)));
        }

        assertThat(disagreements).as("Disagreements").isEmpty();
    }

    private static String shrunk(Differential.Disagreement found) {
        Scenario smallest =
                new Shrinking(s -> Differential.run(s, DifferentialTest::engine).isPresent()).shrink(found.scenario());
        return InWords.of(Differential.run(smallest, DifferentialTest::engine).orElse(found));
    }
}
