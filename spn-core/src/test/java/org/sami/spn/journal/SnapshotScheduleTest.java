package org.sami.spn.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SnapshotScheduleTest {
    private static final int EVERY = 10;

    private final SnapshotSchedule schedule =
            new SnapshotSchedule(JournalOptions.DEFAULT.withSnapshotEvery(EVERY), List.of());

    @Test
    void aSmallSnapshotIsDueAfterItsNumberOfEntriesHoweverShortTheyAre() {
        take(10, 64 * 1024);

        assertThat(schedule.isDue(19)).isFalse();
        assertThat(schedule.isDue(20)).isTrue();
    }

    @Test
    void aLargeSnapshotWaitsForEightTimesItsBytesOfEntries() {
        take(10, 100_000);

        schedule.grew(799_999);
        assertThat(schedule.isDue(5_000)).isFalse();
        schedule.grew(1);
        assertThat(schedule.isDue(5_000)).isTrue();
        assertThat(schedule.isDue(19)).as("long entries alone are no reason").isFalse();
    }

    @Test
    void whatWasWrittenBeforeASnapshotDoesNotCountForTheNext() {
        schedule.grew(1_000_000);
        take(10, 100_000);

        assertThat(schedule.isDue(5_000)).isFalse();
    }

    @Test
    void aSnapshotThatWasNotCommittedIsDueStill() {
        schedule.written(10, 100_000);

        assertThat(schedule.isDue(11)).isTrue();
    }

    private void take(long index, int bytes) {
        assertThat(schedule.isDue(index)).isTrue();
        schedule.written(index, bytes);
        schedule.committed(index);
    }
}
