package org.sami.work.postgres;

import java.util.List;

/** The work in the tables is of other settings than the work of who wants to join. */
public final class OtherWorkException extends WorkException {
    private static final long serialVersionUID = 1;

    private final transient List<String> differences;

    OtherWorkException(String where, List<String> differences) {
        super(where + " holds other work: " + String.join("; ", differences), null);
        this.differences = List.copyOf(differences);
    }

    /** What differs, a phrase each, such as {@code seed: 1 there, 2 here}. */
    public List<String> differences() {
        return differences;
    }
}
