package org.sami.crw.sim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.sami.crw.sim.report.ReportFolder;
import org.sami.crw.sim.report.ReportJson;
import org.sami.crw.sim.report.ReportText;
import org.sami.crw.sim.report.RunReport;
import picocli.CommandLine.Option;

/** How a run is told of. */
final class OutputOptions {
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
    private Path folder;

    /** Text for people, and files. */
    static OutputOptions toFolder(Path folder) {
        OutputOptions options = new OutputOptions();
        options.folder = folder;
        return options;
    }

    /**
     * Makes the report's folder now: a run whose report could not be written would be lost.
     *
     * @throws UsageFault if it cannot be made or written to
     */
    void prepare() {
        if (folder == null) {
            return;
        }
        try {
            new ReportFolder(folder).prepare();
        } catch (IOException e) {
            throw new UsageFault("--report: " + folder + " is no folder and cannot be made one");
        }
        if (!Files.isWritable(folder)) {
            throw new UsageFault("--report: nothing can be written to " + folder);
        }
    }

    /** Writes the report everywhere it is wanted. */
    void tell(RunReport report, PrintWriter out, PrintWriter err) throws IOException {
        if (folder != null) {
            ReportFolder files = new ReportFolder(folder);
            files.write(report);
            err.println("report written to " + folder + ", picture " + files.picture());
            err.flush();
        }
        out.print(json ? ReportJson.text(report) : ReportText.text(report));
        out.flush();
    }
}
