package org.sami.petri.structure;

import java.util.function.BooleanSupplier;

/**
 * How far structure is searched. Numbers of invariants and siphons can be exponential in the size of a net; where a limit ends a search, its result says that it is not
 * complete.
 *
 * @param rows how many rows the search for invariants keeps, besides one a place or transition
 * @param sets how many subproblems the search for siphons or traps looks at
 * @param programs how many linear programs are solved for one question
 * @param cancelled asked often, on the thread of the search: true ends it
 */
public record StructureLimits(int rows, int sets, int programs, BooleanSupplier cancelled) {
    /** Limits that most nets of plans do not meet, and that end others within some seconds. */
    public static final StructureLimits USUAL = new StructureLimits(5_000, 100_000, 500, () -> false);

    public StructureLimits {
        if (rows < 1 || sets < 1 || programs < 1) {
            throw new IllegalArgumentException(
                    "limits are 1 or more: rows " + rows + ", sets " + sets + ", programs " + programs);
        }
    }

    /** The same limits, and a way to cancel. */
    public StructureLimits withCancel(BooleanSupplier asked) {
        return new StructureLimits(rows, sets, programs, asked);
    }
}
