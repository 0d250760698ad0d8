package org.sami.crw.sim.run;

import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.sami.crw.sim.run.record.RunProgress;

/**
 * Watches a run, on the run's thread.
 *
 * @param progress receives the progress, often; must be quick
 * @param stop asked often: whether the user wants it to stop
 * @param news receives decisions and messages of the operator
 */
public record RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop, News news) {
    /** Watches nothing. */
    public static final RunObserver NONE = stopping(() -> false);

    /**
     * The news of a run that a person reads.
     *
     * @param lines is given it line by line; must be quick
     * @param isDetailed whether descriptions, long answers and repeated messages are included
     */
    public record News(Consumer<String> lines, boolean isDetailed) {
        /** No news. */
        public static final News NONE = new News(line -> {}, false);

        public News {
            Objects.requireNonNull(lines, "lines");
        }
    }

    /** Ignores the progress. */
    private enum Nobody implements Consumer<RunProgress> {
        LOOKS;

        @Override
        public void accept(RunProgress progress) {
            // Nobody wants to know.
        }
    }

    public RunObserver {
        Objects.requireNonNull(progress, "progress");
        Objects.requireNonNull(stop, "stop");
        Objects.requireNonNull(news, "news");
    }

    /** An observer that ignores the progress but may stop the run. */
    public static RunObserver stopping(BooleanSupplier stop) {
        return new RunObserver(Nobody.LOOKS, stop);
    }

    /** Whether the progress is used. */
    boolean isWatched() {
        return progress != Nobody.LOOKS;
    }

    /** An observer of the progress alone. */
    public RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop) {
        this(progress, stop, News.NONE);
    }
}
