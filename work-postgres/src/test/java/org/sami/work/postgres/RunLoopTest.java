package org.sami.work.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.work.postgres.testing.TestDatabase;

/** The loop that takes runs and makes them. */
class RunLoopTest {
    private final PostgresAddress address = TestDatabase.address();

    private SharedRuns join(int runs) throws IOException {
        return SharedRuns.join(address, new SharedWork("table", runs, Map.of()), "one", Duration.ofMinutes(10));
    }

    @Test
    void makesEachRunOnce() throws IOException {
        Set<Integer> numbers = new TreeSet<>();
        try (SharedRuns runs = join(20)) {
            boolean all = RunLoop.work(runs, 2, run -> Optional.of("result " + run), () -> false, standing -> {});

            assertThat(all).isTrue();
            numbers.addAll(runs.results().keySet());
            assertThat(runs.results()).containsEntry(7, "result 7");
        }
        assertThat(numbers).hasSize(20);
    }

    @Test
    void theNextCallGoesOnWithWhatWasLeftWhenItWasStopped() throws IOException {
        AtomicBoolean stop = new AtomicBoolean();
        int before;
        try (SharedRuns runs = join(5)) {
            assertThat(RunLoop.work(
                            runs,
                            1,
                            run -> {
                                stop.set(run == 2);
                                return run == 2 ? Optional.empty() : Optional.of("first call");
                            },
                            stop::get,
                            standing -> {}))
                    .isFalse();
            before = runs.results().size();
        }

        try (SharedRuns runs = join(5)) {
            RunLoop.work(runs, 1, run -> Optional.of("second call"), () -> false, standing -> {});

            assertThat(before).isEqualTo(2);
            assertThat(runs.results().values())
                    .containsExactly("first call", "first call", "second call", "second call", "second call");
        }
    }

    @Test
    void aRunThatBreaksItsProgramTwiceIsGivenUpAndTheOthersAreMade() throws IOException {
        for (int worker = 0; worker < 2; worker++) {
            try (SharedRuns runs = join(3)) {
                assertThatThrownBy(() -> RunLoop.work(runs, 1, RunLoopTest::breaking, () -> false, standing -> {}))
                        .isInstanceOf(IllegalStateException.class)
                        .hasCauseInstanceOf(OutOfMemoryError.class);
            }
        }

        try (SharedRuns runs = join(3)) {
            RunLoop.work(runs, 1, RunLoopTest::breaking, () -> false, standing -> {});

            assertThat(runs.standing().givenUp()).containsExactly(1);
            assertThat(runs.results()).containsOnlyKeys(0, 2);
        }
    }

    private static Optional<String> breaking(int run) {
        if (run == 1) {
            throw new OutOfMemoryError("the heap of a test");
        }
        return Optional.of("made");
    }
}
