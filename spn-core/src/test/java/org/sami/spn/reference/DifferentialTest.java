package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.spn.testing.TestVocabulary;

/**
 * The engine and the interpreter agree after every input of hundreds of random sessions on random plans. For thousands, as before a rule changes:
 * {@code ./gradlew :spn-core:longTest --tests '*DifferentialTest' -Pseeds=50000 -PfirstSeed=1}.
 */
@Tag("long")
class DifferentialTest {
    private static final long FIRST_SEED = Long.getLong("spn.firstSeed", 1);
    private static final long SEEDS = Long.getLong("spn.seeds", 600);

    /** How often a build exercises each rule at least, and the sessions that takes. */
    static final long LEAST = 15;

    private static final long ENOUGH_SEEDS = 600;

    private static final int MOST_TOLD = 3;

    private static Subject engine(org.sami.spn.model.Project project) {
        return new EngineSubject(TestVocabulary.TEST, project, Scenario.LIVELOCK_LIMIT);
    }

    /** With the seeds that show a spoilt engine: what a build finds does not depend on how many it tries. */
    @Test
    void engineAndInterpreterAgreeOnRandomPlans() {
        Coverage coverage = new Coverage();
        LongStream seeds = LongStream.concat(
                LongStream.range(FIRST_SEED, FIRST_SEED + SEEDS),
                SpoiltEngineTest.RARE.values().stream().mapToLong(Long::longValue));
        List<String> disagreements = disagreements(seeds.distinct(), Scenario.LENGTH, coverage);

        assertThat(disagreements).as("Disagreements").isEmpty();
        assertThat(coverage.below(SEEDS < ENOUGH_SEEDS ? 0 : LEAST))
                .as("Rules that the sessions exercised less than %d times", LEAST)
                .isEmpty();
    }

    @Test
    void engineAndInterpreterAgreeOnLongSessions() {
        List<String> disagreements = disagreements(from(1_000_000, SEEDS / 30), 150, new Coverage());

        assertThat(disagreements).as("Disagreements").isEmpty();
    }

    @Test
    void engineAndInterpreterAgreeWhenProjectsAreLoaded() {
        Coverage coverage = new Coverage();
        List<String> disagreements = disagreements(
                from(2_000_000, SEEDS / 3),
                seed -> Differential.exploreLoading(seed, 80, DifferentialTest::engine, coverage));

        assertThat(disagreements).as("Disagreements").isEmpty();
        assertThat(coverage.ofLoading(SEEDS < ENOUGH_SEEDS ? 0 : 13))
                .as("What the sessions did with loaded projects less than 13 times")
                .isEmpty();
    }

    /** So many seeds of a kind of session, after as many as a build is asked to leave out. */
    private static LongStream from(long kind, long seeds) {
        return LongStream.range(kind + FIRST_SEED, kind + FIRST_SEED + seeds);
    }

    private static List<String> disagreements(LongStream seeds, int length, Coverage coverage) {
        return disagreements(seeds, seed -> Differential.explore(seed, length, DifferentialTest::engine, coverage));
    }

    /** The first disagreements of so many sessions, made small; sessions know nothing of each other and run on all processors. */
    private static List<String> disagreements(
            LongStream seeds, LongFunction<Optional<Differential.Disagreement>> session) {
        return seeds.parallel()
                .mapToObj(session)
                .flatMap(Optional::stream)
                .limit(MOST_TOLD)
                .map(DifferentialTest::shrunk)
                .toList();
    }

    private static String shrunk(Differential.Disagreement found) {
        Scenario smallest =
                new Shrinking(s -> Differential.run(s, DifferentialTest::engine).isPresent()).shrink(found.scenario());
        return InWords.of(Differential.run(smallest, DifferentialTest::engine).orElse(found));
    }
}
