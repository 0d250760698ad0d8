package org.sami.crw.cli.option;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ErrorMessages;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.report.ReportText;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.file.ReportFolder;
import org.sami.crw.report.file.ReportJson;
import org.sami.session.record.SessionPictures;
import picocli.CommandLine.Option;

/** Where a run's report goes. */
public final class OutputOptions {
    @Option(
            names = "--json",
            description = "Print the report as one JSON object on standard output, and nothing else there.")
    private boolean json;

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description =
                    "Write report.json, boats.csv, locations.csv, firings.csv, tracks.csv, decisions.csv and map.png "
                            + "into this folder.")
    private @Nullable Path folder;

    @Option(
            names = "--overwrite",
            description =
                    "Replace an existing report in the folder of --report. Without this option nothing is run then.")
    private boolean overwrite;

    /** Text for people, and files, which replace those of an earlier report. */
    public static OutputOptions toFolder(Path folder) {
        OutputOptions options = new OutputOptions();
        options.folder = folder;
        options.overwrite = true;
        return options;
    }

    /**
     * Makes the report's folder now: a run whose report could not be written would be lost.
     *
     * @param err receives the notice that a report will be replaced
     * @throws UsageFault if it cannot be made or written to, or holds a report that must not be replaced
     */
    public void prepare(PrintWriter err) {
        if (folder == null) {
            if (overwrite) {
                throw new UsageFault("--overwrite: there is no --report whose folder it could be about");
            }
            return;
        }
        ReportFolder files = new ReportFolder(folder);
        try {
            files.prepare();
        } catch (IOException e) {
            throw new UsageFault("--report: " + folder + " is no folder and cannot be made one");
        }
        if (!Files.isWritable(folder)) {
            throw new UsageFault("--report: nothing can be written to " + folder);
        }
        files.earlier().ifPresent(earlier -> replace(earlier, err));
    }

    /** Where a run keeps the pictures of its boats for the report; empty where there is none. */
    public Optional<SessionPictures> pictures() {
        return Optional.ofNullable(folder).map(path -> SessionPictures.in(path.resolve("pictures")));
    }

    private void replace(Path earlier, PrintWriter err) {
        if (!overwrite) {
            throw new UsageFault("--report: a report is in " + folder + " already (" + earlier.getFileName()
                    + "); choose another folder, or replace it with --overwrite");
        }
        err.println("the report in " + folder + " will be replaced");
        err.flush();
    }

    /**
     * Writes the report to every requested output: first to standard output, which needs no folder. Files that cannot be written are named
     * on standard error.
     *
     * @return whether all files were written
     */
    public boolean tell(RunReport report, PrintWriter out, PrintWriter err) {
        out.print(json ? ReportJson.text(report) : ReportText.text(report));
        out.flush();
        if (folder == null) {
            return true;
        }
        try {
            ReportFolder files = new ReportFolder(folder);
            files.write(report);
            err.println("report written to " + folder + ", picture " + files.picture());
            return true;
        } catch (IOException e) {
            err.println("crw: the report could not be written to " + folder + ": " + ErrorMessages.words(e));
            return false;
        } finally {
            err.flush();
        }
    }
}
