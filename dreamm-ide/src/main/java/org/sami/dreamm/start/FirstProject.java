package org.sami.dreamm.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/**
 * The domain and the project with which a window begins.
 *
 * @param plan the plan that is open at first; empty = the first one
 */
public record FirstProject(DomainLibrary domain, ProjectDocument document, Optional<String> plan) {
    private static final String SHIPPED = "/org/sami/domain/crw";

    public FirstProject {
        Objects.requireNonNull(domain, "domain");
        Objects.requireNonNull(document, "document");
        Objects.requireNonNull(plan, "plan");
    }

    /**
     * Reads what the options name.
     *
     * @throws IOException if it cannot be opened, saying why in one sentence
     */
    public static FirstProject open(DreammOptions options) throws IOException {
        Reading<DomainLibrary> reading = options.domain().isPresent()
                ? DomainLibrary.fromFolder(options.domain().get())
                : DomainLibrary.fromClassPath(SHIPPED);
        DomainLibrary domain = orThrow(
                reading, "the domain " + options.domain().map(Path::toString).orElse(SHIPPED));
        if (options.open().isEmpty()) {
            return new FirstProject(
                    domain,
                    new ProjectDocument(domain.vocabulary(), domain.combined(), Optional.empty()),
                    Optional.empty());
        }
        String named = options.open().get();
        Path path = Path.of(named);
        if (!Files.exists(path) && domain.projectOf(named).isPresent()) {
            return new FirstProject(
                    domain,
                    new ProjectDocument(domain.vocabulary(), domain.combined(), Optional.empty()),
                    Optional.of(named));
        }
        if (!Files.exists(path)) {
            throw new IOException("there is no file, folder or plan of the library " + named);
        }
        Project project = orThrow(new ProjectReader(domain.vocabulary()).read(path), named);
        return new FirstProject(
                domain, new ProjectDocument(domain.vocabulary(), project, Optional.of(path)), Optional.empty());
    }

    private static <T> T orThrow(Reading<T> reading, String what) throws IOException {
        return reading.result()
                .orElseThrow(() -> new IOException(what + " is not opened: "
                        + reading.findings().stream()
                                .filter(Finding::isError)
                                .findFirst()
                                .map(Finding::toString)
                                .orElse("it cannot be read")));
    }
}
