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
 * @param folder on disk; empty = a domain that ships, on the class path
 * @param shipped name of that domain
 */
public record DomainSource(Optional<Path> folder, String shipped) {
    /** The boats' domain. */
    public static final DomainSource SHIPPED = new DomainSource(Optional.empty(), "crw");

    private static final String RESOURCES = "/org/sami/domain/";
    private static final String INDEX = "/domain.json";
    private static final String LEGACY = "legacy.json";

    public DomainSource {
        Objects.requireNonNull(folder, "folder");
        Objects.requireNonNull(shipped, "shipped");
    }

    /** The domain that somebody names: a folder, else one that ships; the boats' where nobody names one. */
    public static DomainSource of(Optional<Path> named) {
        String name = named.map(Path::toString).orElse(SHIPPED.shipped());
        boolean ships =
                name.matches("[a-z][a-z0-9-]*") && DomainSource.class.getResource(RESOURCES + name + INDEX) != null;
        return ships && named.filter(Files::isDirectory).isEmpty()
                ? new DomainSource(Optional.empty(), name)
                : new DomainSource(named, SHIPPED.shipped());
    }

    private String resources() {
        return RESOURCES + shipped;
    }

    /** Reads the words and the library of plans. */
    public Reading<DomainLibrary> library() {
        return folder.map(DomainLibrary::fromFolder).orElseGet(() -> DomainLibrary.fromClassPath(resources()));
    }

    /** What people call it, in sentences that say what is wrong with it. */
    public String title() {
        return "the domain " + folder.map(Path::toString).orElseGet(this::resources);
    }

    /** Whether it has a table of what classes of the earlier system mean. */
    public boolean hasLegacyTable() {
        return folder.map(path -> Files.isRegularFile(path.resolve(LEGACY)))
                .orElseGet(() -> DomainSource.class.getResource(resources() + "/" + LEGACY) != null);
    }

    /** Reads that table. */
    public Reading<LegacyTable> legacyTable(Vocabulary vocabulary) throws IOException {
        return folder.isPresent()
                ? LegacyTableReader.read(Files.readString(folder.get().resolve(LEGACY)), vocabulary)
                : LegacyTableReader.fromClassPath(resources() + "/" + LEGACY, vocabulary);
    }

    @Override
    public String toString() {
        return title();
    }
}
