package org.sami.crw.sim.bench;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.RunPlan;
import org.sami.crw.sim.run.RunSettings;
import org.sami.crw.sim.run.Speed;
import org.sami.figures.Figure;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

/**
 * How many simulated seconds a run takes in a second of this machine, as fast as it goes and once the code is warm: boats that explore
 * an area, each about 2.5 km of it, so that nearly all are under way until the end. Everything of a run counts, its planning too.
 */
final class SpeedBenchmark {
    private static final String NAME = "sim.speed";
    private static final String PLAN = "explore-area";
    private static final double SIDE_M = 350; // of the area of one boat
    private static final long LIMIT_MILLIS = 1_500_000;
    private static final int WARM_UP_BOATS = 10;

    private final int rounds;

    /** Measures each number of boats so many times. */
    SpeedBenchmark(int rounds) {
        this.rounds = rounds;
    }

    /** The median for each number of boats; the last figure is of as many runs side by side as there are cores, taken together. */
    List<Figure> run(int... fleets) throws Exception {
        for (int i = 0; i < 3; i++) {
            speed(WARM_UP_BOATS);
        }
        List<Figure> figures = new ArrayList<>();
        for (int boats : fleets) {
            List<Double> speeds = new ArrayList<>();
            for (int i = 0; i < rounds; i++) {
                speeds.add(speed(boats));
            }
            figures.add(figure(Map.of("boats", boats), speeds));
        }
        int cores = Runtime.getRuntime().availableProcessors();
        List<Double> together = new ArrayList<>();
        for (int i = 0; i < rounds; i++) {
            together.add(sideBySide(cores, WARM_UP_BOATS));
        }
        figures.add(figure(Map.of("boats", WARM_UP_BOATS, "runs", cores), together));
        return figures;
    }

    private static Figure figure(Map<String, Integer> params, List<Double> speeds) {
        Collections.sort(speeds);
        double spread = (speeds.get(speeds.size() - 1) - speeds.get(0)) / 2;
        return new Figure(NAME, params, speeds.get(speeds.size() / 2), "simulated s a second", spread);
    }

    private static double speed(int boats) {
        long begin = System.nanoTime();
        double seconds = simulatedSeconds(boats);
        return seconds / ((System.nanoTime() - begin) / 1e9);
    }

    private static double sideBySide(int runs, int boats) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(runs);
        try {
            long begin = System.nanoTime();
            double seconds = 0;
            for (Future<Double> run :
                    threads.invokeAll(Collections.<Callable<Double>>nCopies(runs, () -> simulatedSeconds(boats)))) {
                seconds += run.get();
            }
            return seconds / ((System.nanoTime() - begin) / 1e9);
        } finally {
            threads.shutdown();
        }
    }

    private static double simulatedSeconds(int boats) {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf(PLAN).orElseThrow();
        RunPlan plan =
                new RunPlan(library.vocabulary(), project, project.plan(PLAN).orElseThrow());
        RunSettings settings = new RunSettings(
                PLAN,
                PLAN,
                new RunSettings.Fleet(boats, 1, SIDE_M * Math.sqrt(boats), 1),
                Speed.MAX,
                OptionalLong.of(LIMIT_MILLIS),
                Map.of(),
                5_000,
                "");
        RunReport report = new InProcessRun(plan, settings, AnswersFile.EMPTY, RunJournal.none())
                .run(Pacer.UNPACED, RunObserver.NONE);
        return report.result().simulatedMillis() / 1000.0;
    }
}
