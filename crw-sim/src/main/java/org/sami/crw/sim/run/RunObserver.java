package org.sami.crw.sim.run;

import java.util.Objects;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Who watches a run, on its thread.
 *
 * @param progress hears how far it is, often; must be quick
 * @param stop asked often: whether the user wants it to stop
 * @param news where it is told what the operator is asked and told
 */
public record RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop, News news) {
    /** Nobody. */
    public static final RunObserver NONE = new RunObserver(progress -> {}, () -> false);

    /**
     * What a person follows of a run.
     *
     * @param lines hears it line by line; must be quick
     * @param isDetailed whether descriptions, long answers and repeated messages are wanted as well
     */
    public record News(Consumer<String> lines, boolean isDetailed) {
        /** Nobody follows. */
        public static final News NONE = new News(line -> {}, false);

        public News {
            Objects.requireNonNull(lines, "lines");
        }
    }

    public RunObserver {
        Objects.requireNonNull(progress, "progress");
        Objects.requireNonNull(stop, "stop");
        Objects.requireNonNull(news, "news");
    }

    /** Somebody who only wants to know how far it is. */
    public RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop) {
        this(progress, stop, News.NONE);
    }
}
