package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.sim.run.record.RunProgress;

class ProgressDisplayTest {
    private static final long SECOND = 1_000_000_000L;

    private final StringWriter text = new StringWriter();
    private long nanos;

    @Test
    void writesOverOneLineOnATerminal() {
        ProgressDisplay display = new ProgressDisplay(new PrintWriter(text), true, () -> nanos);

        display.accept(progress(1000));
        nanos += SECOND;
        display.accept(progress(21_000));
        display.end();

        assertThat(text.toString())
                .doesNotContain("\n")
                .contains("1 s  running")
                .contains("21 s  running");
        assertThat(text.toString()).endsWith("\r\u001b[K");
    }

    @Test
    void writesALineEverySomeSecondsElsewhere() {
        ProgressDisplay display = new ProgressDisplay(new PrintWriter(text), false, () -> nanos);

        for (int i = 0; i < 100; i++) {
            display.accept(progress(i * 1000L));
            nanos += SECOND / 10;
        }
        display.end();

        assertThat(text.toString().lines().count()).isEqualTo(3);
    }

    private static RunProgress progress(long millis) {
        return new RunProgress("running", millis, 2, 12, 1, 5, 97.2);
    }
}
