package org.sami.spn.journal;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.spn.host.JournalException;

/** A kind of database that holds journals; found by {@link java.util.ServiceLoader} when a user names one. Safe for use by several threads. */
public interface JournalStore {
    /** How its addresses begin, before {@code ://}. */
    String scheme();

    /**
     * The address as it is shown, logged and kept.
     *
     * @throws IllegalArgumentException with a sentence for the user, if it is none or holds a password
     */
    String checked(String address);

    /** Whether there is a journal. */
    boolean exists(String address) throws IOException;

    /**
     * A new journal.
     *
     * @throws IOException if there is one, or none can be made
     */
    StoredJournal create(String address, JournalHeader header, JournalOptions options) throws IOException;

    /**
     * Opens a journal to go on with it.
     *
     * @throws IOException if it cannot be read, or somebody else holds it
     */
    StoredJournal open(String address, JournalOptions options) throws IOException;

    /**
     * Waits until there is a journal that somebody has written and nobody holds any more, and opens it to go on with it. Of several that wait one gets it; the others go on waiting.
     *
     * @param lines what is waited for, for people
     * @param ahead what of the journal was read meanwhile; asked once, when nobody else can write any more
     * @throws java.io.InterruptedIOException if the thread is interrupted
     * @throws IOException if the database refuses the first connection, which a later one that fails does not end, or the journal cannot be opened
     */
    StoredJournal takeOver(
            String address, JournalOptions options, Consumer<String> lines, Supplier<Optional<JournalPart>> ahead)
            throws IOException;

    /**
     * The header of a journal that this program can go on with; empty where there is no journal.
     *
     * @throws IOException if the database does not say, or the journal ran by other rules of firing
     */
    Optional<JournalHeader> header(String address) throws IOException;

    /** Opens a journal to read it. */
    default JournalReader read(String address) throws JournalException {
        return read(address, Optional.empty());
    }

    /**
     * Opens a journal to read what is not known of it.
     *
     * @param known what was read before, and is not read again; where the journal is another one by now, all is
     */
    JournalReader read(String address, Optional<JournalPart> known) throws JournalException;
}
