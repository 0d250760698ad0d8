package org.sami.crw.sim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.sami.crw.sim.legacy.ImportReport;
import org.sami.crw.sim.legacy.ImportedProjectFile;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.vocabulary.Vocabulary;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw import-legacy}: projects of the earlier system become projects of this one. */
@Command(
        name = "import-legacy",
        mixinStandardHelpOptions = true,
        description =
                "Imports a project of the earlier system from its neutral export (sami-legacy-project, version 1), "
                        + "counts what arrived and names what did not.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:imported; findings say what arrived otherwise than it stood there",
            "1:the export has errors: nothing is written",
            "2:wrong usage, FILE cannot be read, or OUT is there already"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw import-legacy thesis.json fleet.json", "  crw import-legacy thesis.json fleet --json"})
final class ImportLegacyCommand implements Callable<Integer> {
    static final String TABLE = "/org/sami/domain/crw/legacy.json";

    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "FILE", description = "The export.")
    private Path file;

    @Parameters(
            index = "1",
            paramLabel = "OUT",
            description = "The project to write: a file where the name ends in .json, else a folder. "
                    + "It must not be there yet.")
    private Path out;

    @Option(names = "--json", description = "Print one JSON object on standard output, and nothing else there.")
    private boolean json;

    @Override
    public Integer call() throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new UsageFault("there is no file '" + file + "'");
        }
        ImportedProjectFile target = new ImportedProjectFile(out);
        target.refusal().ifPresent(why -> {
            throw new UsageFault(why);
        });
        DomainLibrary library = PlanSource.library();
        Vocabulary vocabulary = library.vocabulary();
        LegacyTable table = LegacyTableReader.fromClassPath(TABLE, vocabulary).orThrow();
        LegacyImport.Result result = new LegacyImport(vocabulary, table).read(file);
        if (result.project().isPresent()) {
            target.write(result.project().get(), vocabulary);
        }
        ImportReport report = new ImportReport(String.valueOf(file), String.valueOf(out), result);
        PrintWriter writer = spec.commandLine().getOut();
        if (json) {
            writer.println(report.json().toPrettyString());
        } else {
            FindingsText.print(writer, String.valueOf(file), result.findings());
            writer.print(report.text());
        }
        writer.flush();
        return result.project().isPresent() ? ExitCode.OK : ExitCode.FINDINGS;
    }
}
