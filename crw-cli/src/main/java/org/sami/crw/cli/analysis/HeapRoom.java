package org.sami.crw.cli.analysis;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.LongSupplier;
import org.sami.petri.graph.SearchBudget;

/** How much of the heap a search may fill, once its net is there. */
final class HeapRoom {
    /** The collector keeps this part of the heap for objects that have just been made. */
    private static final double KEPT_FREE = 0.08;

    /** What answers and their texts take beside the states, in bytes. */
    private static final long ANSWERS = 5_000_000;

    /** What is kept of earlier queries takes at most a quarter of the budget beside it. */
    private static final double WITH_KEPT_ANSWERS = 1.25;

    private static final double MEGABYTE = 1e6;

    private HeapRoom() {}

    /**
     * The budget, lowered to what the heap still has room for, and a line about it.
     *
     * @param isOfQueries whether several queries are asked, of which one may keep what it found for the next ones
     * @param err where the line goes
     */
    static SearchBudget fitted(SearchBudget budget, boolean isOfQueries, PrintWriter err) {
        Runtime heap = Runtime.getRuntime();
        return fitted(
                budget,
                isOfQueries,
                heap.maxMemory(),
                () -> heap.totalMemory() - heap.freeMemory(),
                Runtime.getRuntime()::gc,
                err);
    }

    /**
     * The same with another heap.
     *
     * @param heap its size in bytes
     * @param used how many bytes of it are in use; after a collection, by objects that are needed
     */
    static SearchBudget fitted(
            SearchBudget budget, boolean isOfQueries, long heap, LongSupplier used, Runnable collect, PrintWriter err) {
        if (budget.bytes() <= most(isOfQueries, heap, used.getAsLong())) {
            return budget;
        }
        collect.run();
        long most = Math.max(1, most(isOfQueries, heap, used.getAsLong()));
        if (budget.bytes() <= most) {
            return budget;
        }
        err.printf(
                Locale.ROOT,
                "crw: the states may take %.1f MB, not %.1f: the heap has %.1f MB, and the net and the program need the"
                        + " rest; more by JAVA_OPTS=-Xmx%dm%n",
                most / MEGABYTE,
                budget.bytes() / MEGABYTE,
                heap / MEGABYTE,
                (long) Math.ceil((heap + (budget.bytes() - most) * 2) / MEGABYTE));
        err.flush();
        return new SearchBudget(budget.states(), most, budget.time());
    }

    private static long most(boolean isOfQueries, long heap, long used) {
        double free = heap * (1 - KEPT_FREE) - ANSWERS - used;
        return (long) (isOfQueries ? free / WITH_KEPT_ANSWERS : free);
    }
}
