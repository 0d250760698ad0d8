package org.sami.crw.sim.run;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Who watches a run, on its thread.
 *
 * @param progress hears how far it is, often; must be quick
 * @param stop asked often: whether the user wants it to stop
 */
public record RunObserver(Consumer<RunProgress> progress, BooleanSupplier stop) {
    /** Nobody. */
    public static final RunObserver NONE = new RunObserver(progress -> {}, () -> false);
}
