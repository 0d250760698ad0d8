package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.server.log.LogHistory;
import org.sami.crw.cli.option.OutputOptions;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.log.LogConversion;
import org.sami.crw.log.LogSummary;
import org.sami.crw.log.LogSummaryJson;
import org.sami.crw.log.LogSummaryText;
import org.sami.crw.log.NotALogException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw log}: what a boat's log holds, of an old one with a picture of its track. */
@Command(
        name = "log",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description =
                "Reads a vehicle log of the boats of 2013 to 2016 (text, one line an entry) and prints what it holds: the "
                        + "track, sensor readings, commands, and every line that could not be read. Of a boat's log of today "
                        + "(crw boat --log, crw logs), any file of it: the commands of all of its files.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:read; unreadable lines are counted and named",
            "1:the file is no log of a boat",
            "2:wrong usage, or there is no such file",
            "4:the file cannot be read, or the report cannot be written"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw log airboat_20130807_063622.txt",
            "  crw log airboat_20130807_063622.txt --report out",
            "  crw log logs/anna/anna.log"
        })
public final class LogCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "The log.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private Path file;

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description = "Write summary.json, tracks.csv, track.geojson, readings.csv, commands.csv, problems.csv and "
                    + "map.png into this folder.")
    private @Nullable Path folder;

    @Option(names = "--json", description = "Print the summary as one JSON object, and nothing else there.")
    private boolean json;

    @Override
    public Integer call() throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new UsageFault("there is no log " + file);
        }
        PrintWriter err = spec.commandLine().getErr();
        if (LogHistory.isOne(file)) {
            return commands(err);
        }
        LogSummary summary;
        try {
            summary = folder == null ? LogConversion.summary(file) : LogConversion.report(file, prepared(folder));
        } catch (NotALogException e) {
            err.println("crw: " + file + " " + e.getMessage());
            err.flush();
            return ExitCode.FINDINGS;
        }
        if (folder != null) {
            boolean drawn = Files.exists(folder.resolve("map.png"));
            err.println("report written to " + folder
                    + (drawn ? ", picture " + folder.resolve("map.png") : "; no picture, for it has no position"));
            err.flush();
        }
        PrintWriter out = spec.commandLine().getOut();
        out.print(json ? LogSummaryJson.text(summary) : LogSummaryText.text(summary));
        out.flush();
        return ExitCode.OK;
    }

    /** A log of commands, as boats keep it today. */
    private int commands(PrintWriter err) throws IOException {
        if (json) {
            throw new UsageFault(
                    "--json is for logs of 2013 to 2016; of a boat's log of commands --report makes a table");
        }
        CommandLogText log = new CommandLogText(file);
        if (folder != null) {
            log.write(prepared(folder));
            err.println("commands written to " + folder.resolve("commands.csv"));
            err.flush();
        }
        log.print(spec.commandLine().getOut());
        return ExitCode.OK;
    }

    private Path prepared(Path reports) {
        OutputOptions.toFolder(reports).prepare(spec.commandLine().getErr());
        return reports;
    }
}
