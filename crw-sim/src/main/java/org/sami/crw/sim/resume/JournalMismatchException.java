package org.sami.crw.sim.resume;

import java.io.IOException;

/** A run that is gone through again does something else than its journal says: it cannot be taken up. */
public final class JournalMismatchException extends IOException {
    private final long entry;

    JournalMismatchException(long entry, String what) {
        super("entry " + entry + " of the journal: " + what);
        this.entry = entry;
    }

    /** Index of the first entry that differs, from 1. */
    public long entry() {
        return entry;
    }
}
