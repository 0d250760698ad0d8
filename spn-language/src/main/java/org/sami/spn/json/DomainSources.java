package org.sami.spn.json;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Where the texts of a domain are read.
 *
 * @param own the files of its own folder, by name
 * @param others the files of other domains, as {@code NAME/FILE}
 */
record DomainSources(DomainSources.Source own, DomainSources.Source others) {
    /** A text by name; empty where there is none. */
    interface Source {
        Optional<String> text(String name) throws IOException;
    }

    /** Where domains lie that come with a program, each in a folder by its name. */
    private static final String SHIPPED = "/org/sami/domain/";

    /** A domain on the class path; the others lie beside it. */
    static DomainSources ofClassPath(String folder) {
        String beside = folder.substring(0, folder.lastIndexOf('/') + 1);
        return new DomainSources(name -> resource(folder + "/" + name), name -> resource(beside + name));
    }

    /** A domain in a folder; the others lie in folders beside it, or come with the program. */
    static DomainSources ofFolder(Path folder) {
        Optional<Path> beside =
                Optional.ofNullable(folder.toAbsolutePath().normalize().getParent());
        return new DomainSources(name -> TextFiles.read(folder, name), name -> {
            Optional<String> found = beside.isPresent() ? TextFiles.read(beside.get(), name) : Optional.empty();
            return found.isPresent() ? found : resource(SHIPPED + name);
        });
    }

    /** The domain's own texts, and those of the domains that it combines; of no others. */
    Source with(List<String> combines) {
        return name -> combines.stream().anyMatch(domain -> name.startsWith(domain + "/"))
                ? others.text(name)
                : own.text(name);
    }

    private static Optional<String> resource(String name) throws IOException {
        try (InputStream in = DomainSources.class.getResourceAsStream(name)) {
            return in == null ? Optional.empty() : Optional.of(JsonText.decode(in.readAllBytes()));
        }
    }
}
