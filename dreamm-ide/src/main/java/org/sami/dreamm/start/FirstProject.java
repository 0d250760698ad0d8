package org.sami.dreamm.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.DomainSource;
import org.sami.dreamm.context.LibraryProject;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.file.ProjectFile;
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
public record FirstProject(DomainSource source, DomainLibrary domain, ProjectDocument document, Optional<String> plan) {
    public FirstProject {
        Objects.requireNonNull(source, "source");
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
        DomainSource source = DomainSource.of(options.domain());
        DomainLibrary domain = orThrow(source.library(), source.title());
        Optional<String> named = options.open();
        Optional<Path> path = named.map(Path::of).filter(Files::exists);
        boolean library = named.isEmpty()
                || (path.isEmpty() && domain.projectOf(named.get()).isPresent());
        if (library) {
            return new FirstProject(
                    source, domain, document(domain, LibraryProject.of(domain), Optional.empty()), named);
        }
        if (path.isEmpty()) {
            throw new IOException("there is no file, folder or plan of the library " + named.get());
        }
        Path home = ProjectFile.home(path.get());
        Project project = orThrow(new ProjectReader(domain.vocabulary()).read(home), named.get());
        return new FirstProject(source, domain, document(domain, project, Optional.of(home)), Optional.empty());
    }

    private static ProjectDocument document(DomainLibrary domain, Project project, Optional<Path> file) {
        return new ProjectDocument(domain.vocabulary(), project, file);
    }

    private static <T> T orThrow(Reading<T> reading, String what) throws IOException {
        return reading.result()
                .orElseThrow(() -> new IOException(what + " is not opened: "
                        + reading.findings().stream()
                                .filter(Finding::isError)
                                .findFirst()
                                .map(FirstProject::words)
                                .orElse("it cannot be read")));
    }

    private static String words(Finding finding) {
        return finding.location().map(at -> at.file() + ":" + at.line() + ": ").orElse("") + finding.message();
    }
}
