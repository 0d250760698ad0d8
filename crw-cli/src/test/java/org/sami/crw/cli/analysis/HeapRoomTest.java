package org.sami.crw.cli.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.SearchBudget;

/** A search gets no more memory than the heap has left. */
class HeapRoomTest {
    private static final long HEAP = 100_000_000;

    private final StringWriter err = new StringWriter();
    private long used;
    private int collections;

    private long fitted(long bytes, boolean isOfQueries, long usedAfterCollection) {
        SearchBudget budget = new SearchBudget(1000, bytes, Duration.ofSeconds(9));
        SearchBudget fitted = HeapRoom.fitted(
                budget,
                isOfQueries,
                HEAP,
                () -> used,
                () -> {
                    collections++;
                    used = usedAfterCollection;
                },
                new PrintWriter(err));
        assertThat(fitted.states()).isEqualTo(budget.states());
        assertThat(fitted.time()).isEqualTo(budget.time());
        return fitted.bytes();
    }

    @Test
    void whatFitsStaysWithoutACollection() {
        used = 10_000_000;

        assertThat(fitted(77_000_000, false, 0)).isEqualTo(77_000_000);
        assertThat(collections).isZero();
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void garbageTakesNoRoom() {
        used = 90_000_000;

        assertThat(fitted(77_000_000, false, 10_000_000)).isEqualTo(77_000_000);
        assertThat(collections).isEqualTo(1);
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void whatDoesNotFitIsLoweredAndSaid() {
        used = 60_000_000;

        assertThat(fitted(50_000_000, false, 54_000_000)).isEqualTo(33_000_000);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines(
                        "crw: the states may take 33.0 MB, not 50.0: the heap has 100.0 MB, and the net and the program"
                                + " need the rest; more by JAVA_OPTS=-Xmx134m\n");
    }

    @Test
    void whatQueriesKeepTakesRoomToo() {
        used = 54_000_000;

        assertThat(fitted(50_000_000, true, 54_000_000)).isEqualTo(26_400_000);
    }

    @Test
    void aHeapThatIsFullLeavesOneByte() {
        used = HEAP;

        assertThat(fitted(50_000_000, true, HEAP)).isEqualTo(1);
    }
}
