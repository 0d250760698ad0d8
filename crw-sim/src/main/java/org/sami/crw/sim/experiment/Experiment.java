package org.sami.crw.sim.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;

/**
 * Cases, each run in each of several conditions with each of several seeds. Runs go side by side, each in a world of its own: what comes
 * of them is the same on any number of threads.
 */
public final class Experiment {
    private final List<Trial> trials = new ArrayList<>();

    /** One run that is to be made. */
    private record Trial(ExperimentCase of, String conditions, RunSettings settings) {
        ExperimentRow.Run run() {
            return new ExperimentRow.Run(
                    of.label(), conditions, settings.fleet().seed());
        }
    }

    /** A row and where it belongs; none where the run was stopped. */
    private record Done(int index, List<ExperimentRow> row) {}

    /**
     * An experiment.
     *
     * @param conditions by name, in the order in which tables have them
     */
    public Experiment(List<ExperimentCase> cases, Map<String, Conditions> conditions, List<Long> seeds) {
        for (ExperimentCase one : cases) {
            conditions.forEach((name, water) -> {
                for (long seed : seeds) {
                    FleetSettings fleet = one.settings().fleet().on(water).drawnFrom(seed);
                    trials.add(new Trial(one, name, one.settings().withFleet(fleet)));
                }
            });
        }
    }

    /** How many runs it has. */
    public int size() {
        return trials.size();
    }

    /**
     * Makes the runs, and returns what came of them in the order of cases, conditions and seeds. Those that are under way when it is to
     * stop are left out, as are those that have not begun; it does not wait until they have come to their end.
     *
     * @param threads how many runs go at a time
     * @param stop asked often, from several threads: whether somebody wants it to stop; who wants it at once interrupts the caller's thread as well
     * @param progress receives on the caller's thread how many runs are done
     */
    public List<ExperimentRow> run(int threads, BooleanSupplier stop, IntConsumer progress) {
        Objects.requireNonNull(progress, "progress");
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            CompletionService<Done> runs = new ExecutorCompletionService<>(pool);
            for (int i = 0; i < trials.size(); i++) {
                int index = i;
                runs.submit(() -> new Done(index, row(trials.get(index), stop)));
            }
            List<List<ExperimentRow>> rows = new ArrayList<>();
            trials.forEach(trial -> rows.add(List.of()));
            for (int count = 1; count <= trials.size(); count++) {
                Optional<Done> done = next(runs, stop);
                if (done.isEmpty()) {
                    break;
                }
                rows.set(done.get().index(), done.get().row());
                progress.accept(count);
            }
            return rows.stream().flatMap(List::stream).toList();
        } finally {
            pool.shutdown();
        }
    }

    /** Its runs, for several machines. */
    public Portions<ExperimentRow> portions() {
        return new Portions<>() {
            @Override
            public int count() {
                return trials.size();
            }

            @Override
            public Optional<String> make(int portion, BooleanSupplier stop) {
                return row(trials.get(portion), stop).stream().findFirst().map(ExperimentRowText::write);
            }

            @Override
            public List<ExperimentRow> rows(Map<Integer, String> results, Map<Integer, String> givenUp) {
                Map<Integer, ExperimentRow> rows = new TreeMap<>();
                givenUp.forEach((portion, reason) -> rows.put(
                        portion, ExperimentRow.failed(trials.get(portion).run(), reason)));
                results.forEach((portion, text) -> rows.put(portion, ExperimentRowText.read(text)));
                return List.copyOf(rows.values());
            }
        };
    }

    private static List<ExperimentRow> row(Trial trial, BooleanSupplier stop) {
        if (stop.getAsBoolean()) {
            return List.of();
        }
        String label = trial.of().label();
        try {
            ExperimentRow row = ExperimentRow.of(
                    label,
                    trial.conditions(),
                    new InProcessRun(
                                    trial.of().plan(),
                                    trial.settings(),
                                    trial.of().answers(),
                                    RunJournal.none())
                            .run(Pacer.UNPACED, RunObserver.stopping(stop)));
            return stop.getAsBoolean() ? List.of() : List.of(row);
        } catch (RuntimeException fault) { // a row that says so, among those of the other runs
            return List.of(ExperimentRow.broken(
                    label, trial.conditions(), trial.settings().fleet().seed(), fault));
        }
    }

    /** Waits for the next run that is done; empty if it is to stop and none is. An interrupt only says that somebody wants an end. */
    private static Optional<Done> next(CompletionService<Done> runs, BooleanSupplier stop) {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    Future<Done> done = stop.getAsBoolean() ? runs.poll() : runs.take();
                    return done == null ? Optional.empty() : Optional.of(done.get());
                } catch (InterruptedException wantsAnEnd) {
                    interrupted = true;
                }
            }
        } catch (ExecutionException broken) {
            throw new IllegalStateException(broken.getCause());
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
