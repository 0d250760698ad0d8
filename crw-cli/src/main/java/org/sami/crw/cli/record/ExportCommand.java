package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.JournalConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.report.OperatorActionsPart;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.file.ReportFolder;
import org.sami.crw.sim.tcp.JournalReport;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw export}: what is in a journal as tables and a map, for other programs. Changes nothing; a writer may be running. */
@Command(
        name = "export",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Writes what is in the journal of a session, or of a run with --connect, for other programs: boat"
                + " tracks, firings, decisions, messages, readings, tasks, phases and the operator's log as CSV;"
                + " tracks, paths and areas as GeoJSON. All missions together; the journal is only read.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:written", "2:wrong usage, or there is no such file", "4:the journal cannot be read"},
        footerHeading = "%nExamples:%n",
        footer = {"  crw export today.journal today"})
public final class ExportCommand implements Callable<Integer> {
    private static final String IN_PROCESS = "in-process";

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "JOURNAL",
            converter = JournalConverter.class,
            description = "A file that 'crw session --journal' or 'crw run --connect --journal' wrote, or"
                    + " postgresql://HOST:PORT/DATABASE.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private JournalAddress file;

    @Parameters(
            index = "1",
            paramLabel = "DIR",
            description = "The folder for the files; it is made where there is none.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path folder;

    @Option(names = "--overwrite", description = "Replace files of these names that are in the folder already.")
    private boolean overwrite;

    @Override
    public Integer call() throws IOException {
        if (!file.exists()) {
            throw new UsageFault("there is no journal " + file);
        }
        try (JournalReader reader = file.read()) {
            if (IN_PROCESS.equals(reader.header().settings().get("kind"))) {
                throw new UsageFault(
                        "the boats of " + file + " were in its own process, and a run with them is done again: crw "
                                + "resume " + file + " --report " + folder);
            }
        }
        ReportFolder files = new ReportFolder(folder);
        if (!overwrite && files.exported().isPresent()) {
            throw new UsageFault(files.exported().get()
                    + " is there already; choose another folder, or replace it with " + "--overwrite");
        }
        RunReport report = JournalReport.of(file);
        files.export(report);
        PrintWriter out = spec.commandLine().getOut();
        out.printf(
                "%s: %d boats, %d firings, %d decisions, %d messages, %d entries of the operator's log written to %s%n",
                file,
                report.boats().size(),
                report.firings().size(),
                report.decisions().size(),
                report.notes().size(),
                report.part(OperatorActionsPart.class)
                        .map(part -> part.actions().size())
                        .orElse(0),
                folder);
        out.flush();
        return ExitCode.OK;
    }
}
