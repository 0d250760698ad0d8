package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A clock that counts the time in which the machine slept. */
class ElapsedTimeTest {
    private static final long MILLI = 1_000_000;

    private long nanos = 7_000 * MILLI;
    private long bootNanos = 9_000 * MILLI;
    private long wallMillis = 1_000_000;
    private boolean saysSinceBoot = true;

    /** As of Linux, or of a system that does not say since when it has been on. */
    private ElapsedTime clock() {
        return new ElapsedTime(() -> nanos, ElapsedTime.counting(this::sinceBoot, () -> wallMillis));
    }

    private OptionalLong sinceBoot() {
        return saysSinceBoot ? OptionalLong.of(bootNanos) : OptionalLong.empty();
    }

    private void pass(long awakeMillis, long allMillis, long wall) {
        nanos += awakeMillis * MILLI;
        bootNanos += allMillis * MILLI;
        wallMillis += wall;
    }

    private static long passedMillis(ElapsedTime clock, long began) {
        return (clock.getAsLong() - began) / MILLI;
    }

    @Test
    void countsWhatPassesWhileTheMachineIsAwake() {
        ElapsedTime clock = clock();
        long began = clock.getAsLong();
        pass(300, 310, 301);
        assertThat(passedMillis(clock, began)).isEqualTo(300);
        pass(5000, 4990, 4999);
        assertThat(passedMillis(clock, began)).isEqualTo(5300);
    }

    @Test
    void countsTheTimeOfASleepOnceAlsoWhereTheMachinesClockIsSetBackAtWaking() {
        ElapsedTime clock = clock();
        long began = clock.getAsLong();
        pass(100, 30_100, 50);
        assertThat(passedMillis(clock, began)).isEqualTo(30_100);
        pass(100, 100, 100);
        assertThat(passedMillis(clock, began)).isEqualTo(30_200);
    }

    @Test
    void aMachinesClockThatIsSetChangesNothing() {
        ElapsedTime clock = clock();
        long began = clock.getAsLong();
        pass(100, 100, 86_400_000);
        assertThat(passedMillis(clock, began)).isEqualTo(100);
        pass(100, 100, -86_400_000);
        assertThat(passedMillis(clock, began)).isEqualTo(200);
    }

    @Test
    void countsASleepLaterWhereTheTimeSinceBootCannotBeReadForAMoment() {
        ElapsedTime clock = clock();
        long began = clock.getAsLong();
        saysSinceBoot = false;
        pass(100, 30_100, 30_100);
        assertThat(passedMillis(clock, began)).isEqualTo(100);
        saysSinceBoot = true;
        pass(100, 100, 100);
        assertThat(passedMillis(clock, began)).isEqualTo(30_200);
    }

    @Test
    void countsASleepByTheMachinesClockWhereTheSystemDoesNotSayHowLongItHasBeenOn() {
        saysSinceBoot = false;
        ElapsedTime clock = clock();
        long began = clock.getAsLong();
        pass(100, 30_100, 30_100);
        assertThat(passedMillis(clock, began)).isEqualTo(30_100);
        pass(100, 100, -86_400_000);
        assertThat(passedMillis(clock, began)).as("it never goes back").isEqualTo(30_200);
    }

    @Test
    void theTimeSinceBootIsTheFirstNumberOfItsFile(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("uptime"), "12345.67 54321.00\n");
        assertThat(SinceBoot.nanos(file)).hasValue(12_345_670_000_000L);
        assertThat(SinceBoot.nanos(folder.resolve("none"))).isEmpty();
        assertThat(SinceBoot.nanos(Files.writeString(file, "what\n"))).isEmpty();
    }
}
