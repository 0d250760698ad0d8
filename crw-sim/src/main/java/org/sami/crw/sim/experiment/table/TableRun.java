package org.sami.crw.sim.experiment.table;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BooleanSupplier;
import org.sami.crw.sim.experiment.Portions;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * All repetitions of an experiment's configurations, side by side, each in a world of its own: what comes of them is the same on any number of threads.
 * Repetitions that were made earlier are taken over.
 */
public final class TableRun {
    private final List<Repetition> repetitions = new ArrayList<>(); // of one configuration after another
    private final int count;

    /** Receives what is made, on the caller's thread. */
    public interface Listener {
        /** A repetition was made. */
        void made(List<RunRow> rows) throws IOException;

        /** So many runs of all have been made. */
        void progress(int done, int of);
    }

    private record Done(int index, Optional<List<RunRow>> rows) {}

    /**
     * The repetitions of an experiment.
     *
     * @param count number of repetitions of each configuration
     * @param seed of the first
     * @param project with all plans that its scripts start
     */
    public TableRun(ExperimentFile file, int count, long seed, Vocabulary vocabulary, Project project) {
        this.count = count;
        for (ExperimentFile.Configuration one : file.configurations()) {
            for (int number = 1; number <= count; number++) {
                repetitions.add(new Repetition(file, one, number, seed, vocabulary, project));
            }
        }
    }

    /** Number of runs, if no repetition is drawn again. */
    public int size() {
        return repetitions.stream().mapToInt(Repetition::runs).sum();
    }

    /**
     * Makes those that are missing.
     *
     * @param earlier rows of earlier calls; of those only whole repetitions count
     * @param stop asked often, from several threads: whether somebody wants it to stop
     * @return the rows in the order of configurations and repetitions; fewer than all where it was stopped
     */
    public List<RunRow> run(List<RunRow> earlier, int threads, BooleanSupplier stop, Listener listener)
            throws IOException {
        Map<Integer, List<RunRow>> rows = new TreeMap<>();
        for (int i = 0; i < repetitions.size(); i++) {
            List<RunRow> known = known(repetitions.get(i), earlier);
            if (!known.isEmpty()) {
                rows.put(i, known);
            }
        }
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            CompletionService<Done> work = new ExecutorCompletionService<>(pool);
            int left = 0;
            for (int index : firstOfEachFirst()) {
                if (!rows.containsKey(index)) {
                    left++;
                    work.submit(() -> new Done(
                            index,
                            stop.getAsBoolean()
                                    ? Optional.empty()
                                    : repetitions.get(index).run(stop)));
                }
            }
            listener.progress(runs(rows), size());
            for (; left > 0; left--) {
                Optional<Done> done = next(work, stop);
                if (done.isEmpty()) {
                    break;
                }
                if (done.get().rows().isPresent()) {
                    listener.made(done.get().rows().get());
                    rows.put(done.get().index(), done.get().rows().get());
                }
                listener.progress(runs(rows), size());
            }
        } finally {
            pool.shutdown();
        }
        return rows.values().stream().flatMap(List::stream).toList();
    }

    /** Its repetitions, for several machines. */
    public Portions<RunRow> portions() {
        return new RepetitionPortions(repetitions, firstOfEachFirst());
    }

    /** The first repetition of every configuration, then the second ones: what is stopped has something of each line of the table. */
    private List<Integer> firstOfEachFirst() {
        List<Integer> order = new ArrayList<>();
        for (int number = 0; number < count; number++) {
            for (int i = number; i < repetitions.size(); i += count) {
                order.add(i);
            }
        }
        return order;
    }

    private int runs(Map<Integer, List<RunRow>> rows) {
        return rows.keySet().stream()
                .mapToInt(index -> repetitions.get(index).runs())
                .sum();
    }

    /** The rows of a repetition; none where one is missing, as after a crash. */
    private static List<RunRow> known(Repetition wanted, List<RunRow> earlier) {
        List<RunRow> rows = earlier.stream()
                .filter(row -> row.at().configuration().equals(wanted.configuration())
                        && row.at().repetition() == wanted.number())
                .toList();
        long counted = rows.stream().filter(row -> row.at().isCounted()).count();
        return counted == wanted.runs() ? rows : List.of();
    }

    /** Waits for the next repetition; empty if it is to stop. An interrupt only says that somebody wants an end. */
    private static Optional<Done> next(CompletionService<Done> work, BooleanSupplier stop) {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    Future<Done> done = stop.getAsBoolean() ? work.poll() : work.take();
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
