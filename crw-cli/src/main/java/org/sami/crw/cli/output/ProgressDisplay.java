package org.sami.crw.cli.output;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.sami.crw.report.ReportWords;
import org.sami.crw.sim.run.record.RunProgress;

/**
 * Shows how far a run is, on standard error: one line that changes on a terminal, else a line every few seconds. For the
 * thread of the run.
 */
public final class ProgressDisplay implements Consumer<RunProgress> {
    private static final long TERMINAL_NANOS = 200_000_000L;
    private static final long LINE_NANOS = 3_000_000_000L;

    private final PrintWriter out;
    private final boolean terminal;
    private final LongSupplier nanos;
    private long nextNanos;
    private boolean lineIsOpen;

    /**
     * A display.
     *
     * @param terminal whether the line can be written over
     * @param nanos a clock that never goes back
     */
    public ProgressDisplay(PrintWriter out, boolean terminal, LongSupplier nanos) {
        this.out = out;
        this.terminal = terminal;
        this.nanos = nanos;
        nextNanos = nanos.getAsLong() + (terminal ? 0 : LINE_NANOS / 3);
    }

    @Override
    public void accept(RunProgress progress) {
        show(() -> words(progress));
    }

    /** Shows how far something else is. */
    public void show(Supplier<String> words) {
        long now = nanos.getAsLong();
        if (now - nextNanos < 0) {
            return;
        }
        nextNanos = now + (terminal ? TERMINAL_NANOS : LINE_NANOS);
        if (terminal) {
            out.print(TerminalWriter.CLEAR_LINE);
            out.print(words.get());
            lineIsOpen = true;
        } else {
            out.println(words.get());
        }
        out.flush();
    }

    /** Leaves the line, so that something else can be written. */
    public void end() {
        if (lineIsOpen) {
            out.print(TerminalWriter.CLEAR_LINE);
            out.flush();
            lineIsOpen = false;
        }
    }

    static String words(RunProgress progress) {
        return String.format(
                Locale.ROOT,
                "%s  %s%s  firings %d  open decisions %d  least battery %.0f %%",
                ReportWords.duration(progress.simulatedMillis()),
                progress.phase(),
                progress.locations() == 0 ? "" : "  visited " + progress.visited() + "/" + progress.locations(),
                progress.firings(),
                progress.openDecisions(),
                progress.leastBatteryPercent());
    }
}
