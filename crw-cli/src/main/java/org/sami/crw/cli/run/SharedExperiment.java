package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.sami.crw.cli.output.ProgressDisplay;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.report.ReportWords;
import org.sami.crw.sim.experiment.Portions;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.journal.postgres.ProcessName;
import org.sami.work.postgres.OtherWorkException;
import org.sami.work.postgres.RunLoop;
import org.sami.work.postgres.SharedRuns;
import org.sami.work.postgres.SharedWork;
import org.sami.work.postgres.Standing;

/** Makes the runs of an experiment together with other machines, and says how far all of them are. */
final class SharedExperiment {
    private static final String GIVEN_UP = "given up: the process that made it ended twice meanwhile";

    private final PostgresAddress address;
    private final String portionsWord;
    private final PrintWriter err;
    private final ProgressDisplay progress;
    private long beganNanos;
    private int doneBefore = -1;

    /**
     * An experiment.
     *
     * @param address where its runs stand
     * @param portionsWord what is divided, such as {@code runs}
     */
    SharedExperiment(PostgresAddress address, String portionsWord, PrintWriter err) {
        this.address = address;
        this.portionsWord = portionsWord;
        this.err = err;
        progress = new ProgressDisplay(err, Terminal.onStandardError(), System::nanoTime);
    }

    /**
     * Makes runs until none is left on any machine.
     *
     * @param name of the experiment at its address
     * @param settings all that results depend on
     * @param threads how many portions this machine makes at a time
     * @return the rows of all machines; fewer than all where it was stopped
     * @throws UsageFault where an experiment of other settings stands there
     */
    <R> List<R> rows(String name, Portions<R> portions, Map<String, String> settings, int threads, BooleanSupplier stop)
            throws IOException {
        SharedWork work = new SharedWork(name, portions.count(), settings);
        try (SharedRuns runs = SharedRuns.join(address, work, ProcessName.ofThisProcess(), SharedRuns.LEASE)) {
            beganNanos = System.nanoTime();
            RunLoop.work(runs, threads, portion -> portions.make(portion, stop), stop, this::show);
            progress.end();
            Standing standing = runs.standing();
            tell(standing);
            Map<Integer, String> givenUp = new TreeMap<>();
            standing.givenUp().forEach(portion -> givenUp.put(portion, GIVEN_UP));
            return portions.rows(runs.results(), givenUp);
        } catch (OtherWorkException other) {
            throw new UsageFault("--workers: the experiment at " + address.words()
                    + " is another one; join it with its settings, or name another schema:\n  "
                    + String.join("\n  ", other.differences()));
        }
    }

    private void show(Standing standing) {
        if (doneBefore < 0) {
            doneBefore = standing.done();
            if (doneBefore > 0) {
                err.println(doneBefore + " " + portionsWord + " of " + standing.runs() + " were made before");
                err.flush();
            }
        }
        progress.show(() -> words(standing));
    }

    private String words(Standing standing) {
        return standing.done() + " of " + standing.runs() + " " + portionsWord + left(standing)
                + standing.workers().stream()
                        .filter(Standing.Worker::isThere)
                        .map(worker -> worker.name() + " " + worker.done())
                        .collect(Collectors.joining(", ", "; at work: ", ""));
    }

    private String left(Standing standing) {
        int made = standing.done() - doneBefore;
        int missing = standing.runs() - standing.done() - standing.givenUp().size();
        if (made == 0 || missing == 0) {
            return "";
        }
        long nanos = (System.nanoTime() - beganNanos) / made * missing;
        return ", about " + ReportWords.duration(Duration.ofNanos(nanos).toMillis()) + " left";
    }

    private void tell(Standing standing) {
        err.println(standing.done() + " of " + standing.runs() + " " + portionsWord + " are made: "
                + standing.workers().stream()
                        .filter(worker -> worker.done() > 0)
                        .map(worker -> worker.done() + " by " + worker.name())
                        .collect(Collectors.joining(", ")));
        if (!standing.givenUp().isEmpty()) {
            int count = standing.givenUp().size();
            err.println(count + " of the " + portionsWord + (count == 1 ? " is" : " are")
                    + " given up: the processes that made them ended twice meanwhile");
        }
        err.flush();
    }
}
