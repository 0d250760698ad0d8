package org.sami.crw.sim.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.ToDoubleFunction;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunJournal;
import org.sami.crw.sim.run.RunObserver;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.figures.Figure;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;

/**
 * How many simulated seconds a run takes in a second of this machine, as fast as it goes and once the code is warm: boats that explore
 * an area, each some 1.4 km of it, so that nearly all are under way until the end; with the ways there and home a charge lasts for that.
 * Everything of a run counts, its planning too.
 */
final class SpeedBenchmark {
    private static final String NAME = "sim.speed";
    private static final String PLAN = "explore-area";
    private static final double SIDE_M = 90; // of the area of one boat
    private static final Map<String, String> LANES = Map.of("@spacing", "6"); // in metres
    private static final long LIMIT_MILLIS = 1_500_000;
    private static final int WARM_UP_BOATS = 10;
    private static final int WARM_UPS = 16; // with fewer the compiler is still at work while ten boats are measured

    private final int rounds;

    /** Measures each number of boats so many times. */
    SpeedBenchmark(int rounds) {
        this.rounds = rounds;
    }

    /** The medians for each number of boats; the last figures are of as many runs side by side as there are cores, taken together. */
    List<Figure> run(int... fleets) throws Exception {
        for (int i = 0; i < WARM_UPS; i++) {
            measured(WARM_UP_BOATS, true);
        }
        List<Figure> figures = new ArrayList<>();
        for (int boats : fleets) {
            List<Sample> samples = new ArrayList<>();
            for (int i = 0; i < rounds; i++) {
                samples.add(measured(boats, true));
            }
            figures.addAll(figures(Map.of("boats", boats), samples));
        }
        int cores = Runtime.getRuntime().availableProcessors();
        List<Sample> together = new ArrayList<>();
        for (int i = 0; i < rounds; i++) {
            together.add(sideBySide(cores, WARM_UP_BOATS));
        }
        figures.addAll(figures(Map.of("boats", WARM_UP_BOATS, "runs", cores), together));
        return figures;
    }

    /**
     * What was taken of one measurement.
     *
     * @param simulatedS of all its runs
     * @param wallS until the last of them had ended
     * @param cpuS processor time of the threads of the runs, without those that help them, of the compiler and of the garbage collector
     */
    private record Sample(double simulatedS, double wallS, double cpuS) {
        double perWallS() {
            return simulatedS / wallS;
        }

        double perCpuS() {
            return simulatedS / cpuS;
        }
    }

    private static List<Figure> figures(Map<String, Integer> params, List<Sample> samples) {
        return List.of(
                figure(NAME, params, samples, Sample::perWallS, "simulated s a second"),
                figure(NAME + ".cpu", params, samples, Sample::perCpuS, "simulated s a CPU second"));
    }

    private static Figure figure(
            String name,
            Map<String, Integer> params,
            List<Sample> samples,
            ToDoubleFunction<Sample> speed,
            String unit) {
        double[] speeds = samples.stream().mapToDouble(speed).sorted().toArray();
        double spread = (speeds[speeds.length - 1] - speeds[0]) / 2;
        return new Figure(name, params, speeds[speeds.length / 2], unit, spread);
    }

    private static Sample sideBySide(int runs, int boats) throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(runs);
        try {
            long begin = System.nanoTime();
            double simulatedS = 0;
            double cpuS = 0;
            for (Future<Sample> run :
                    threads.invokeAll(Collections.<Callable<Sample>>nCopies(runs, () -> measured(boats, false)))) {
                simulatedS += run.get().simulatedS();
                cpuS += run.get().cpuS();
            }
            return new Sample(simulatedS, seconds(System.nanoTime() - begin), cpuS);
        } finally {
            threads.shutdown();
        }
    }

    /**
     * One run on this thread.
     *
     * @param alone whether it has all cores for itself
     */
    private static Sample measured(int boats, boolean alone) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long begin = System.nanoTime();
        long cpu = threads.getCurrentThreadCpuTime();
        double simulatedS = simulatedSeconds(boats, alone);
        return new Sample(
                simulatedS, seconds(System.nanoTime() - begin), seconds(threads.getCurrentThreadCpuTime() - cpu));
    }

    private static double seconds(long nanos) {
        return nanos / 1e9;
    }

    private static double simulatedSeconds(int boats, boolean alone) {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf(PLAN).orElseThrow();
        RunPlan plan =
                new RunPlan(library.vocabulary(), project, project.plan(PLAN).orElseThrow());
        RunSettings settings = RunSettings.of(PLAN, PLAN, new FleetSettings(boats, 1, SIDE_M * Math.sqrt(boats), 1))
                .limitMillis(LIMIT_MILLIS)
                .parameters(LANES)
                .build();
        InProcessRun run = new InProcessRun(plan, settings, AnswersFile.EMPTY, RunJournal.none());
        if (alone) {
            run.useAllCores();
        }
        RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);
        return report.result().simulatedMillis() / 1000.0;
    }
}
