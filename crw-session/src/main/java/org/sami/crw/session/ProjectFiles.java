package org.sami.crw.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.session.archive.SavedGlobals;
import org.sami.session.api.RefusedException;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.GlobalsFile;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads, checks and saves projects for a session: slow work, for a thread of its own. A refusal is a {@link RefusedException}. */
final class ProjectFiles {
    private final Vocabulary vocabulary;

    ProjectFiles(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** The project of a file or a folder. */
    Project read(Path path) {
        try {
            return of(path + ": ", BoundedFile.making(path, () -> new ProjectReader(vocabulary).read(path)));
        } catch (IOException tooLarge) {
            throw new RefusedException("the project is not loaded: " + tooLarge.getMessage());
        }
    }

    /** The document of a project without errors. */
    String checked(Project project) {
        of("", new Reading<>(Optional.of(project), PlanChecks.check(project, vocabulary)));
        return new ProjectWriter(vocabulary).text(project);
    }

    private static Project of(String where, Reading<Project> reading) {
        if (reading.result().isEmpty() || reading.hasErrors()) {
            throw new RefusedException("the project is not loaded: " + words(where, reading.findings()));
        }
        return reading.result().get();
    }

    /** Makes values of globals the initial ones of a project's file or folder. */
    SavedGlobals save(Map<String, Value> values, Path path) {
        try {
            Reading<List<GlobalsFile.Change>> saved = new GlobalsFile(vocabulary).save(values, path);
            return new SavedGlobals(
                    saved.result()
                            .orElseThrow(() ->
                                    new RefusedException("nothing is saved: " + words(path + ": ", saved.findings()))),
                    saved.findings());
        } catch (IOException fault) {
            throw new RefusedException("nothing is saved: " + path + " cannot be written: " + fault.getMessage());
        }
    }

    /** A project whose globals begin with these values. */
    static Project withValues(Project project, Map<String, Value> values) {
        return project.withGlobals(project.globals().stream()
                .map(global -> new VariableSpec(
                        global.name(),
                        global.type(),
                        Optional.ofNullable(values.get(global.name())).or(global::initial)))
                .toList());
    }

    /** Writes a project to a file that is not there yet. */
    Void saveNew(Project project, Path path) {
        if (Files.exists(path)) {
            throw new RefusedException("nothing is saved: " + path + " is there already");
        }
        try {
            new ProjectWriter(vocabulary).write(project, path);
            return null;
        } catch (IOException fault) {
            throw new RefusedException("nothing is saved: " + path + " cannot be written: " + fault.getMessage());
        }
    }

    /** The first thing that is wrong, where, and how much there is. */
    private static String words(String where, List<Finding> findings) {
        Finding first = findings.stream().filter(Finding::isError).findFirst().orElse(findings.get(0));
        String place = first.location()
                .map(at -> at + ": ")
                .orElse(where + (first.pointer().isEmpty() ? "" : first.pointer() + ": "));
        return place + first.message() + (findings.size() > 1 ? " (and " + (findings.size() - 1) + " more)" : "");
    }
}
