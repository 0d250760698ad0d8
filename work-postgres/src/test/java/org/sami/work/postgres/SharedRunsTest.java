package org.sami.work.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.sql.SQLException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.work.postgres.testing.TestDatabase;

/** Leases of runs, who may join, and what is left by a worker that dies. */
class SharedRunsTest {
    private static final Map<String, String> SETTINGS = Map.of("seed", "1", "program's version", "0.1.0");
    /** No worker of a test renews a lease: whether it is over, the test says. */
    private static final Duration LEASE = Duration.ofHours(1);

    private final PostgresAddress address = TestDatabase.address();

    private SharedRuns join(int runs, String worker) throws IOException {
        return SharedRuns.join(address, new SharedWork("table", runs, SETTINGS), worker, LEASE);
    }

    /** As after the death of every worker. */
    private void endLeases() throws SQLException {
        TestDatabase.run(address, "UPDATE runs SET ends = '-infinity'");
    }

    @Test
    void twoWorkersNeverTakeTheSameRun() throws IOException {
        try (SharedRuns one = join(3, "one");
                SharedRuns other = join(3, "other")) {
            assertThat(List.of(one.take(), other.take(), one.take()))
                    .containsExactly(OptionalInt.of(0), OptionalInt.of(1), OptionalInt.of(2));
            assertThat(other.take()).isEmpty();
            assertThat(other.standing().underWay()).isEqualTo(3);
        }
    }

    @Test
    void resultsOfAllWorkersAreThereForEach() throws IOException {
        try (SharedRuns one = join(2, "one");
                SharedRuns other = join(2, "other")) {
            one.done(one.take().orElseThrow(), "a");
            other.done(other.take().orElseThrow(), "b");

            assertThat(one.results()).isEqualTo(Map.of(0, "a", 1, "b")).isEqualTo(other.results());
            assertThat(one.standing().isOver()).isTrue();
            assertThat(one.standing().workers())
                    .containsExactly(new Standing.Worker("one", 1, 0, true), new Standing.Worker("other", 1, 0, true));
        }
    }

    @Test
    void anotherWorkerTakesTheRunOfOneThatDied() throws Exception {
        try (SharedRuns dead = join(1, "dead");
                SharedRuns alive = join(1, "alive")) {
            dead.take();
            assertThat(alive.take()).isEmpty();

            endLeases();

            assertThat(alive.take()).hasValue(0);
        }
    }

    @Test
    void aRunWhoseWorkersDiedTwiceIsGivenUp() throws Exception {
        try (SharedRuns first = join(2, "first");
                SharedRuns second = join(2, "second")) {
            first.take();
            endLeases();
            second.take();
            endLeases();

            assertThat(first.take()).hasValue(1);
            first.done(1, "a");
            assertThat(first.take()).isEmpty();
            assertThat(first.standing().givenUp()).containsExactly(0);
            assertThat(first.standing().isOver()).isTrue();
        }
    }

    @Test
    void aRunWhoseSecondWorkerStandsStillIsNotGivenUpAtOnce() throws Exception {
        try (SharedRuns first = join(1, "first");
                SharedRuns second = join(1, "second")) {
            first.take();
            endLeases();
            second.take();

            TestDatabase.run(address, "UPDATE runs SET ends = clock_timestamp()");

            assertThat(first.take()).isEmpty();
            assertThat(first.standing().givenUp()).isEmpty();
            assertThat(first.standing().isOver()).isFalse();
        }
    }

    @Test
    void aResultThatComesLateCountsAllTheSame() throws Exception {
        try (SharedRuns slept = join(1, "slept");
                SharedRuns other = join(1, "other")) {
            slept.take();
            endLeases();
            other.take();
            endLeases();

            slept.done(0, "a");
            other.done(0, "b");

            assertThat(other.results()).isEqualTo(Map.of(0, "a"));
            assertThat(other.standing().givenUp()).isEmpty();
        }
    }

    @Test
    void whoLeavesGivesItsRunsBackAndTheyDoNotCountAsBegun() throws IOException {
        for (int i = 0; i < 3; i++) {
            try (SharedRuns stopped = join(1, "stopped " + i)) {
                assertThat(stopped.take()).hasValue(0);
            }
        }

        try (SharedRuns next = join(1, "next")) {
            assertThat(next.take()).hasValue(0);
            assertThat(next.standing().workers().stream().filter(Standing.Worker::isThere))
                    .hasSize(1);
        }
    }

    @Test
    void nobodyJoinsWithOtherSettingsOrAnotherNumberOfRuns() throws IOException {
        join(2, "one").close();

        assertThatThrownBy(() -> SharedRuns.join(
                        address, new SharedWork("table", 2, Map.of("seed", "2", "boats", "3")), "other", LEASE))
                .isInstanceOfSatisfying(
                        OtherWorkException.class,
                        other -> assertThat(other.differences())
                                .containsExactlyInAnyOrder(
                                        "seed: 1 there, 2 here",
                                        "boats: not set there, 3 here",
                                        "program's version: 0.1.0 there, not set here"));
        assertThatThrownBy(() -> join(3, "other")).hasMessageContaining("number of runs: 2 there, 3 here");
    }

    @Test
    void aSchemaWithAJournalIsRefused() throws SQLException {
        TestDatabase.run(address, "CREATE SCHEMA " + address.schema());
        TestDatabase.run(address, "CREATE TABLE schema_version (version int)");

        assertThatThrownBy(() -> join(1, "one")).hasMessageContaining("holds the journal of a session");
    }

    @Test
    void aDatabaseThatIsNotThereIsNamedWithoutAPassword() {
        PostgresAddress nowhere = PostgresAddress.parse("postgresql://localhost:1/boats?user=pilot");

        assertThatThrownBy(() -> SharedRuns.join(nowhere, new SharedWork("table", 1, SETTINGS), "one", LEASE))
                .isInstanceOf(WorkException.class)
                .hasMessage("postgresql://localhost:1/boats: no database answers there");
    }
}
