package org.sami.petri.structure;

import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * How far structure is searched. Numbers of invariants and siphons can be exponential in the size of a net; where a limit ends a search, its result says that it is not
 * complete.
 *
 * @param rows how many rows the search for invariants keeps, besides one a place or transition
 * @param sets how many subproblems the search for siphons or traps looks at
 * @param programs how many linear programs are solved for one question
 * @param cancelled asked often, on the thread of the search: true ends it
 * @param millisLeft how long one linear program may take from now on, in ms; none takes more than ten seconds
 */
public record StructureLimits(int rows, int sets, int programs, BooleanSupplier cancelled, LongSupplier millisLeft) {
    private static final long NANOS_PER_MILLI = 1_000_000;

    /** Limits that most nets of plans do not meet, and that end others within some seconds. */
    public static final StructureLimits USUAL = new StructureLimits(5_000, 100_000, 500, () -> false);

    public StructureLimits {
        if (rows < 1 || sets < 1 || programs < 1) {
            throw new IllegalArgumentException(
                    "limits are 1 or more: rows " + rows + ", sets " + sets + ", programs " + programs);
        }
    }

    /** Limits without a time for linear programs, but for the ten seconds. */
    public StructureLimits(int rows, int sets, int programs, BooleanSupplier cancelled) {
        this(rows, sets, programs, cancelled, () -> Long.MAX_VALUE);
    }

    /**
     * The same limits until a time.
     *
     * @param deadline in ns, as the clock says
     * @param nanos a clock that never goes back
     */
    public StructureLimits until(long deadline, LongSupplier nanos) {
        return new StructureLimits(
                rows,
                sets,
                programs,
                () -> cancelled.getAsBoolean() || nanos.getAsLong() - deadline >= 0,
                () -> Math.max(1, (deadline - nanos.getAsLong()) / NANOS_PER_MILLI));
    }

    /** The same limits, and a way to cancel. */
    public StructureLimits withCancel(BooleanSupplier asked) {
        return new StructureLimits(rows, sets, programs, asked, millisLeft);
    }
}
