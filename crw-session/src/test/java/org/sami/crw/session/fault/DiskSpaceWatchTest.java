package org.sami.crw.session.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.health.HealthFault;
import org.sami.spn.protocol.Priority;

class DiskSpaceWatchTest {
    private static final long MB = 1 << 20;
    private static final long MINUTE = 60_000;

    private final DiskSpaceWatch watch = new DiskSpaceWatch();

    private static String text(Optional<HealthFault> said) {
        return said.orElseThrow().text();
    }

    @Test
    void saysForHowLongTheRoomLastsByWhatTheSessionWrites() {
        assertThat(watch.look(0, 10 * MB, 1000 * MB)).isEmpty();
        assertThat(watch.look(MINUTE, 11 * MB, 999 * MB)).isEmpty(); // 999 minutes

        Optional<HealthFault> said = watch.look(2 * MINUTE, 60 * MB, 950 * MB);
        assertThat(text(said)).isEqualTo("The journal's disk has 950 MB left: room for about 40 minutes");
        assertThat(said.orElseThrow().severity()).isEqualTo(Priority.MEDIUM);
    }

    @Test
    void countsWhatOthersWriteThere() {
        watch.look(0, 10 * MB, 2000 * MB);
        assertThat(text(watch.look(MINUTE, 10 * MB, 1800 * MB)))
                .isEqualTo("The journal's disk has 1800 MB left: room for about 9 minutes");
    }

    @Test
    void littleRoomIsSaidBeforeAnythingWasWritten() {
        assertThat(text(watch.look(0, MB, 40 * MB))).isEqualTo("The journal's disk has 40 MB left");
        Optional<HealthFault> none = watch.look(1000, MB, 3 * MB / 2);
        assertThat(text(none)).isEqualTo("The journal's disk has 1.5 MB left");
        assertThat(none.orElseThrow().severity()).isEqualTo(Priority.HIGH);
    }

    @Test
    void warningEndsWhenThereIsClearlyMoreRoom() {
        assertThat(watch.look(0, MB, 49 * MB)).isPresent();
        assertThat(watch.look(1000, MB, 51 * MB)).isPresent();
        assertThat(watch.look(2000, MB, 70 * MB)).isEmpty();
        assertThat(watch.look(3000, MB, 51 * MB)).isEmpty();
    }

    @Test
    void whatWasWrittenLongAgoCountsNoLonger() {
        watch.look(0, 0, 1000 * MB);
        watch.look(MINUTE, 500 * MB, 500 * MB);
        assertThat(watch.look(2 * MINUTE, 500 * MB, 500 * MB)).isPresent();
        watch.look(12 * MINUTE, 500 * MB, 500 * MB);
        assertThat(watch.look(13 * MINUTE, 501 * MB, 499 * MB)).isEmpty();
    }
}
