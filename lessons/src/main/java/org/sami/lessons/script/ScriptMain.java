package org.sami.lessons.script;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/** Makes a plan file from another and a script, for authors of lessons: {@code ScriptMain START.json SCRIPT.json OUT.json}. */
public final class ScriptMain {
    private static final String DOMAIN = "/org/sami/domain/crw";

    private ScriptMain() {}

    /** Ends with 0, or with 2 where a file cannot be read, or an element of the script cannot be done. */
    public static void main(String[] args) throws IOException {
        System.exit(run(List.of(args), System.err));
    }

    static int run(List<String> args, PrintStream err) throws IOException {
        if (args.size() != 3) {
            err.println("START.json SCRIPT.json OUT.json: the project, the script, and the file to be written");
            return 2;
        }
        DomainLibrary domain = DomainLibrary.fromClassPath(DOMAIN).orThrow();
        Path script = Path.of(args.get(1));
        Optional<Project> start = told(new ProjectReader(domain.vocabulary()).read(Path.of(args.get(0))), err);
        Optional<EditScript> edits = told(EditScript.read(script.toString(), Files.readString(script)), err);
        if (start.isEmpty() || edits.isEmpty()) {
            return 2;
        }
        ScriptRun run = edits.get().applyTo(start.get(), domain);
        if (run.refusal().isPresent()) {
            err.println(script + ": " + run.refusal().get().message());
            return 2;
        }
        new ProjectWriter(domain.vocabulary()).write(run.project(), Path.of(args.get(2)));
        return 0;
    }

    private static <T> Optional<T> told(Reading<T> reading, PrintStream err) {
        for (Finding finding : reading.findings()) {
            err.println(finding.location().map(at -> at + ": ").orElse("") + finding.message());
        }
        return reading.result();
    }
}
