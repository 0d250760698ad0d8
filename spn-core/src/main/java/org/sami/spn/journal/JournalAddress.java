package org.sami.spn.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.spn.host.JournalException;

/**
 * Where a journal is: a file, or a database that a {@link JournalStore} knows, such as {@code postgresql://HOST:PORT/DATABASE}. Holds no password. Stores are looked for when a database
 * is named, and never for a file.
 */
public final class JournalAddress {
    private static final String DATABASE = "://";

    private final String text;
    private final Optional<Path> file;
    private final Optional<JournalStore> store;

    private JournalAddress(String text, Optional<Path> file, Optional<JournalStore> store) {
        this.text = text;
        this.file = file;
        this.store = store;
    }

    /** A file. */
    public static JournalAddress of(Path file) {
        return new JournalAddress(file.toString(), Optional.of(file), Optional.empty());
    }

    /**
     * What a user names.
     *
     * @throws IllegalArgumentException with a sentence for the user, if no store knows it or its store refuses it
     */
    public static JournalAddress parse(String text) {
        int scheme = text.indexOf(DATABASE);
        if (scheme < 0) {
            return of(Path.of(text));
        }
        String name = text.substring(0, scheme);
        for (JournalStore store : ServiceLoader.load(JournalStore.class)) {
            if (store.scheme().equals(name)) {
                return new JournalAddress(store.checked(text), Optional.empty(), Optional.of(store));
            }
        }
        throw new IllegalArgumentException(
                "journals are files or postgresql://HOST:PORT/DATABASE, not " + name + DATABASE + "...");
    }

    /** The file; empty for a database. */
    public Optional<Path> file() {
        return file;
    }

    /**
     * Whether there is a journal.
     *
     * @throws IOException if a database does not say
     */
    public boolean exists() throws IOException {
        return store.isPresent()
                ? store.get().exists(text)
                : file.filter(Files::isRegularFile).isPresent();
    }

    /**
     * A new journal.
     *
     * @throws IOException if there is one, or none can be made
     */
    public StoredJournal create(JournalHeader header, JournalOptions options) throws IOException {
        return store.isPresent()
                ? store.get().create(text, header, options)
                : SqliteJournal.create(file.orElseThrow(), header, options);
    }

    /**
     * Opens a journal to go on with it.
     *
     * @throws IOException if it cannot be read, somebody else writes it, or it ran by other rules of firing
     */
    public StoredJournal open(JournalOptions options) throws IOException {
        return store.isPresent() ? store.get().open(text, options) : SqliteJournal.open(file.orElseThrow(), options);
    }

    /**
     * Waits until there is a journal that somebody has written and nobody holds any more, and opens it to go on with it. Of several that wait one gets it; the others go on waiting.
     *
     * @param lines what is waited for, for people
     * @param ahead what of the journal was read meanwhile; asked once, when nobody else can write any more
     * @throws IllegalStateException if this is a file, which one laptop has alone
     * @throws java.io.InterruptedIOException if the thread is interrupted
     * @throws IOException if the database refuses the first connection, which a later one that fails does not end, or the journal cannot be opened
     */
    public StoredJournal takeOver(JournalOptions options, Consumer<String> lines, Supplier<Optional<JournalPart>> ahead)
            throws IOException {
        return inDatabase().takeOver(text, options, lines, ahead);
    }

    /**
     * The header of a journal in a database; empty where there is no journal yet.
     *
     * @throws IllegalStateException if this is a file
     * @throws IOException if the database does not say, or the journal ran by other rules of firing
     */
    public Optional<JournalHeader> header() throws IOException {
        return inDatabase().header(text);
    }

    private JournalStore inDatabase() {
        return store.orElseThrow(() -> new IllegalStateException(text + " is a file"));
    }

    /**
     * Opens a journal to read it; somebody may be writing it.
     *
     * @throws JournalException where not even the header is true
     */
    public JournalReader read() throws JournalException {
        return read(Optional.empty());
    }

    /** Opens a journal to read what is behind a part that was read before; all of it where it is another journal by now. */
    JournalReader read(Optional<JournalPart> known) throws JournalException {
        return store.isPresent() ? store.get().read(text, known) : JournalReader.open(file.orElseThrow(), known);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof JournalAddress address && address.text.equals(text);
    }

    @Override
    public int hashCode() {
        return Objects.hashCode(text);
    }

    /** As the user names it. */
    @Override
    public String toString() {
        return text;
    }
}
