package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.report.ReportWords;
import org.sami.crw.sim.experiment.table.BoxPlots;
import org.sami.crw.sim.experiment.table.ExperimentFile;
import org.sami.crw.sim.experiment.table.ResultTable;
import org.sami.crw.sim.experiment.table.RunRow;
import org.sami.crw.sim.experiment.table.RunRowsFile;
import org.sami.crw.sim.experiment.table.TableFormats;
import org.sami.crw.sim.experiment.table.TableRun;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes the runs of one experiment, with progress, and writes and prints its table. Goes on with the runs that its folder holds. */
final class TableJob {
    private static final String SETTINGS = "experiment.txt";

    private final ExperimentFile experiment;
    private final Vocabulary vocabulary;
    private final Project project;
    private final PrintWriter out;
    private final PrintWriter err;
    private final ProgressDisplay progress;
    private final Optional<SharedTable> shared;
    private long beganNanos;
    private int doneBefore = -1;

    /**
     * A job.
     *
     * @param shared how other machines take part; empty where none does
     */
    TableJob(
            ExperimentFile experiment,
            Vocabulary vocabulary,
            Project project,
            PrintWriter out,
            PrintWriter err,
            Optional<SharedTable> shared) {
        this.experiment = experiment;
        this.vocabulary = vocabulary;
        this.project = project;
        this.out = out;
        this.err = err;
        this.shared = shared;
        progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
    }

    /**
     * Makes it.
     *
     * @param folder where its files go; null for none
     * @return the exit code
     */
    int run(int repetitions, long seed, int threads, @Nullable Path folder, boolean overwrite, BooleanSupplier stop)
            throws IOException {
        TableRun run = new TableRun(experiment, repetitions, seed, vocabulary, project);
        Optional<RunRowsFile> file = folder == null ? Optional.empty() : Optional.of(open(folder, seed, overwrite));
        List<RunRow> earlier = file.isPresent() ? file.get().read() : List.of();
        err.printf("%s: %d runs, %d at a time%n", experiment.title(), run.size(), threads);
        err.flush();
        beganNanos = System.nanoTime();
        List<RunRow> rows = shared.isPresent()
                ? shared.get().rows(experiment.id(), run, threads, stop)
                : run.run(earlier, threads, stop, listener(file));
        progress.end();
        boolean interrupted = Thread.interrupted(); // the files are still to be written
        boolean stopped = interrupted || stop.getAsBoolean();
        ResultTable table = ResultTable.of(experiment, rows);
        out.print(TableFormats.text(table));
        out.println();
        out.flush();
        if (file.isPresent() && folder != null) {
            file.get().replace(rows, earlier);
            write(folder, table, !stopped);
        }
        if (stopped) {
            err.println(
                    folder == null && shared.isEmpty()
                            ? "stopped: not all runs were made; with --out the next call goes on"
                            : "stopped: not all runs were made; the same command goes on");
            err.flush();
            return ExitCode.RUNNING;
        }
        return table.faults().isEmpty() ? ExitCode.OK : ExitCode.PROBLEMS;
    }

    private TableRun.Listener listener(Optional<RunRowsFile> file) {
        return new TableRun.Listener() {
            @Override
            public void made(List<RunRow> made) throws IOException {
                if (file.isPresent()) {
                    file.get().add(made);
                }
            }

            @Override
            public void progress(int done, int of) {
                show(done, of);
            }
        };
    }

    private void show(int done, int of) {
        if (doneBefore < 0) {
            doneBefore = done;
            if (done > 0) {
                err.println(done + " of them were made earlier");
                err.flush();
            }
        }
        int made = done - doneBefore;
        long nanos = System.nanoTime() - beganNanos;
        String left = made == 0 || done >= of
                ? ""
                : ", about "
                        + ReportWords.duration(
                                Duration.ofNanos(nanos / made * (of - done)).toMillis()) + " left";
        progress.show(() -> done + " of " + of + " runs" + left);
    }

    private RunRowsFile open(Path folder, long seed, boolean overwrite) throws IOException {
        Files.createDirectories(folder);
        Path settings = folder.resolve(SETTINGS);
        Path rows = folder.resolve("runs.csv");
        String text = settings(seed);
        if (overwrite) {
            Files.deleteIfExists(rows);
        } else if (Files.exists(rows)
                && (!Files.exists(settings) || !Files.readString(settings).equals(text))) {
            throw new UsageFault("--out: " + folder
                    + " holds runs of another experiment or of other settings; choose another folder, or"
                    + " replace them with --overwrite");
        }
        Files.writeString(settings, text);
        return new RunRowsFile(rows);
    }

    /** What rows depend on, apart from their configuration and their repetition. */
    private String settings(long seed) {
        StringBuilder text = new StringBuilder("experiment " + experiment.id() + "\nseed " + seed + "\n");
        experiment.configurations().get(0).variables().forEach((name, value) -> {
            if (!experiment.factors().containsKey(name) && !experiment.derived().containsKey(name)) {
                text.append(name).append(' ').append(value).append('\n');
            }
        });
        if (experiment.design() == ExperimentFile.Design.ONE_FACTOR_AT_A_TIME) {
            text.append("one factor at a time\n");
        }
        return text.append("factors ")
                .append(String.join(" ", experiment.factors().keySet()))
                .append('\n')
                .append(experiment.scripts().get("versions"))
                .append('\n')
                .toString();
    }

    private static void write(Path folder, ResultTable table, boolean withPicture) throws IOException {
        Files.writeString(folder.resolve("table.txt"), TableFormats.text(table));
        Files.writeString(folder.resolve("table.csv"), TableFormats.csv(table));
        Files.writeString(folder.resolve("table.html"), TableFormats.html(table));
        if (withPicture) { // a process that ends can load no graphics any more
            Files.write(folder.resolve("table.png"), BoxPlots.png(table));
        }
    }
}
