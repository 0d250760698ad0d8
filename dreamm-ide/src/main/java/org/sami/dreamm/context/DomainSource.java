package org.sami.dreamm.context;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.Reading;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Where a domain's words, plans and tables come from.
 *
 * @param folder on disk; empty = the domain that ships, on the class path
 */
public record DomainSource(Optional<Path> folder) {
    /** The domain that ships. */
    public static final DomainSource SHIPPED = new DomainSource(Optional.empty());

    private static final String RESOURCES = "/org/sami/domain/crw";
    private static final String LEGACY = "legacy.json";

    public DomainSource {
        Objects.requireNonNull(folder, "folder");
    }

    /** Reads the words and the library of plans. */
    public Reading<DomainLibrary> library() {
        return folder.map(DomainLibrary::fromFolder).orElseGet(() -> DomainLibrary.fromClassPath(RESOURCES));
    }

    /** What people call it, in sentences that say what is wrong with it. */
    public String title() {
        return "the domain " + folder.map(Path::toString).orElse(RESOURCES);
    }

    /** Whether it has a table of what classes of the earlier system mean. */
    public boolean hasLegacyTable() {
        return folder.map(path -> Files.isRegularFile(path.resolve(LEGACY)))
                .orElseGet(() -> DomainSource.class.getResource(RESOURCES + "/" + LEGACY) != null);
    }

    /** Reads that table. */
    public Reading<LegacyTable> legacyTable(Vocabulary vocabulary) throws IOException {
        return folder.isPresent()
                ? LegacyTableReader.read(Files.readString(folder.get().resolve(LEGACY)), vocabulary)
                : LegacyTableReader.fromClassPath(RESOURCES + "/" + LEGACY, vocabulary);
    }

    @Override
    public String toString() {
        return title();
    }
}
