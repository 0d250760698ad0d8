package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.report.statistics.SessionFigures;
import org.sami.crw.report.statistics.StatisticsFormats;
import org.sami.crw.sim.run.record.JournalStatistics;
import org.sami.spn.journal.JournalAddress;
import picocli.CommandLine;
import picocli.CommandLine.Option;

/** The statistics that {@code crw journal} prints, and their form. */
final class StatisticsOptions {
    @Option(
            names = "--statistics",
            required = true,
            description = "Print what the missions of each plan needed, of all journals together: number, times,"
                    + " decisions, clicks, interrupts, boats, distance.")
    @SuppressWarnings("UnusedVariable") // without it there are no such options
    private boolean isAsked;

    @Option(names = "--json", description = "Print the statistics as one JSON object.")
    private boolean json;

    @Option(names = "--csv", description = "Print the statistics as CSV, a row for each plan.")
    private boolean csv;

    /** Prints the statistics of these journals together. */
    int print(List<JournalAddress> files, CommandLine command) throws IOException {
        if (json && csv) {
            throw new UsageFault("the statistics are printed as --json or as --csv: give one of them");
        }
        SessionFigures all = SessionFigures.NONE;
        for (JournalAddress file : files) {
            all = all.with(JournalStatistics.of(file));
        }
        all.remarks().forEach(remark -> command.getErr().println("crw: " + remark));
        command.getErr().flush();
        PrintWriter out = command.getOut();
        if (json) {
            out.println(StatisticsFormats.json(all).toPrettyString());
        } else {
            out.print(csv ? StatisticsFormats.csv(all) : StatisticsFormats.text(all));
        }
        out.flush();
        return ExitCode.OK;
    }
}
