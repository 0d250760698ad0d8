package org.sami.spn.host;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** A journal cannot be read or written; says which file and which entry. */
public final class JournalException extends IOException {
    private final transient Path file;
    private final long entry;
    private final String what;

    /**
     * A fault of a journal.
     *
     * @param entry the first entry that is concerned; 0 where it is the file's head, or the file as a whole
     * @param what a sentence without its subject, such as "does not follow its predecessor"
     */
    public JournalException(Path file, long entry, String what, @Nullable Throwable cause) {
        super(file + ", " + (entry == 0 ? "head" : "entry " + entry) + ": " + what, cause);
        this.file = Objects.requireNonNull(file, "file");
        this.entry = entry;
        this.what = Objects.requireNonNull(what, "what");
    }

    /** A fault of a journal that nothing else caused. */
    public JournalException(Path file, long entry, String what) {
        this(file, entry, what, null);
    }

    /** What is wrong, one sentence in plain words, such as {@code the journal cannot be written: the disk is full}. */
    public String reason() {
        return "the journal " + what;
    }

    /** Where it is wrong, and what the machine says of it. */
    public String details() {
        String where = file + ", " + (entry == 0 ? "head" : "entry " + entry);
        String said = getCause() == null ? null : getCause().getMessage();
        return said == null || what.contains(said) ? where : where + ": " + said;
    }

    /** The journal's file. */
    public Path file() {
        return file;
    }

    /** The first entry that is concerned, from 1; 0 for the file's head. */
    public long entry() {
        return entry;
    }
}
