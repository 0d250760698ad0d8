package org.sami.spn.host;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** A journal cannot be read or written; says which journal and which entry. */
public final class JournalException extends IOException {
    private final String where;
    private final long entry;
    private final String what;

    /**
     * A fault of a journal.
     *
     * @param where the journal's file, or the address of its database, which holds no password
     * @param entry the first entry that is concerned; 0 where it is the file's head, or the file as a whole
     * @param what a sentence without its subject, such as "does not follow its predecessor"
     */
    public JournalException(String where, long entry, String what, @Nullable Throwable cause) {
        super(where + ", " + (entry == 0 ? "head" : "entry " + entry) + ": " + what, cause);
        this.where = Objects.requireNonNull(where, "where");
        this.entry = entry;
        this.what = Objects.requireNonNull(what, "what");
    }

    /** A fault of a journal's file. */
    public JournalException(Path file, long entry, String what, @Nullable Throwable cause) {
        this(file.toString(), entry, what, cause);
    }

    /** A fault of a journal's file that nothing else caused. */
    public JournalException(Path file, long entry, String what) {
        this(file.toString(), entry, what, null);
    }

    /** A fault of a journal that nothing else caused. */
    public JournalException(String where, long entry, String what) {
        this(where, entry, what, null);
    }

    /** What is wrong, one sentence in plain words, such as {@code the journal cannot be written: the disk is full}. */
    public String reason() {
        return "the journal " + what;
    }

    /** Where it is wrong, and what the machine says of it. */
    public String details() {
        String place = where + ", " + (entry == 0 ? "head" : "entry " + entry);
        String said = getCause() == null ? null : getCause().getMessage();
        return said == null || what.contains(said) ? place : place + ": " + said;
    }

    /** The journal's file, or the address of its database. */
    public String where() {
        return where;
    }

    /** The first entry that is concerned, from 1; 0 for the file's head. */
    public long entry() {
        return entry;
    }
}
