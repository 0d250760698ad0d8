package org.sami.crw.sim.run;

import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.sami.crw.sim.run.record.RunProgress;

/**
 * Who watches a run, on its thread.
 *
 * @param progress receives the progress, often; must be quick
 * @param stop asked often: whether the user wants it to stop
 * @param news receives decisions and messages of the operator
 */
public record RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop, News news) {
    /** Nobody. */
    public static final RunObserver NONE = stopping(() -> false);

    /**
     * What a person follows of a run.
     *
     * @param lines is given it line by line; must be quick
     * @param isDetailed whether descriptions, long answers and repeated messages are included
     */
    public record News(Consumer<String> lines, boolean isDetailed) {
        /** Nobody follows. */
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

    /** Somebody who does not look how far it is, and may want it to stop. */
    public static RunObserver stopping(BooleanSupplier stop) {
        return new RunObserver(Nobody.LOOKS, stop);
    }

    /** Whether anybody wants to know how far it is. */
    boolean isWatched() {
        return progress != Nobody.LOOKS;
    }

    /** Somebody who only wants to know how far it is. */
    public RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop) {
        this(progress, stop, News.NONE);
    }
}
