package org.sami.crw.session.fault;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.crw.session.fault.MemoryWatch.Verdict;

class MemoryWatchTest {
    private static final long MOST = 1000;

    private final MemoryWatch watch = new MemoryWatch();

    private Verdict minuteOf(long... used) {
        Verdict last = Verdict.SAME;
        for (int second = 0; second < 60; second++) {
            last = watch.look(used[second % used.length], MOST);
        }
        return last;
    }

    @Test
    void memoryThatTheCollectorFreesAgainAndAgainIsNoFault() {
        assertThat(minuteOf(990, 950, 300)).isEqualTo(Verdict.WELL);
    }

    @Test
    void memoryThatIsNeverFreedIsSaidUntilThereIsClearlyMore() {
        assertThat(minuteOf(990, 950, 920)).isEqualTo(Verdict.NEARLY_NONE);
        assertThat(minuteOf(850)).isEqualTo(Verdict.NEARLY_NONE);
        assertThat(minuteOf(700)).isEqualTo(Verdict.WELL);
        assertThat(minuteOf(850)).isEqualTo(Verdict.SAME);
    }

    @Test
    void nothingIsSaidBeforeAMinuteWasSeen() {
        for (int second = 0; second < 59; second++) {
            assertThat(watch.look(999, MOST)).isEqualTo(Verdict.SAME);
        }
        assertThat(watch.look(999, MOST)).isEqualTo(Verdict.NEARLY_NONE);
    }
}
