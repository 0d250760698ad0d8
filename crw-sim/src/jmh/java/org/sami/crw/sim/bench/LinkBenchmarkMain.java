package org.sami.crw.sim.bench;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;

/**
 * Runs the benchmarks of the simulator, of the link, of the services and of hours of a run, prints tables and puts them into the file of all benchmarks.
 * System properties: {@code benchmarks.file}; {@code quick} = true for less than two minutes; {@code only} = the beginning of the names of those that
 * are run, empty for all.
 */
public final class LinkBenchmarkMain {
    private static final String SPEED = "sim.speed";
    private static final String PREFIX = "link.";
    private static final String PROTECTED = "link.tls";
    private static final String BOAT_STEP = "boat.step";
    private static final String SERVICES = "service.";
    private static final String BALANCE = "service.balance";
    private static final String HEAP = "heap.growth";
    private static final String JOURNAL = "journal.growth";

    private LinkBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        boolean quick = Boolean.getBoolean("quick");
        Path file = FigureFile.ofThisBuild();
        if (isWanted(SPEED)) {
            note(file, SPEED, new SpeedBenchmark(quick ? 3 : 9).run(1, 10, 100, 250));
        }
        if (isWanted(PREFIX)) {
            List<Figure> figures = new ArrayList<>(codec(quick));
            figures.addAll(new FleetBenchmark(250, quick ? 4 : 10, quick ? 8 : 30).run());
            figures.addAll(new UploadBenchmark(10_000, quick ? 5 : 25).run());
            note(file, PREFIX, figures);
        }
        if (isWanted(PROTECTED)) {
            note(file, PROTECTED, new ProtectedLinkBenchmark(quick ? 4 : 30, quick ? 6 : 20, quick ? 1 : 3).run());
        }
        if (isWanted(BOAT_STEP)) {
            note(file, BOAT_STEP, new BoatStepBenchmark(8).run());
        }
        if (isWanted(SERVICES)) {
            note(file, SERVICES, services(quick));
        }
        if (isWanted(BALANCE)) {
            note(file, BALANCE, new BalanceBenchmark(quick).run());
        }
        if (isWanted(HEAP)) {
            List<Figure> growth = new GrowthBenchmark(25, quick ? 3 : 100).run();
            note(file, HEAP, growth.subList(0, 1));
            note(file, JOURNAL, growth.subList(1, 2));
        }
        System.out.println("Written to " + file);
    }

    private static boolean isWanted(String benchmark) {
        return benchmark.startsWith(System.getProperty("only", ""));
    }

    private static void note(Path file, String name, List<Figure> figures) throws IOException {
        FigureFile.print(figures);
        FigureFile.replace(file, name, figures);
    }

    private static List<Figure> services(boolean quick) throws RunnerException {
        List<Figure> figures = new ArrayList<>();
        for (RunResult result : new Runner(options(ServiceBenchmarks.class, quick)).run()) {
            Result<?> primary = result.getPrimaryResult();
            double error = primary.getScoreError();
            figures.add(new Figure(
                    SERVICES + primary.getLabel(),
                    Map.of(),
                    primary.getScore(),
                    "ms",
                    Double.isNaN(error) ? 0 : error));
        }
        return figures;
    }

    private static Options options(Class<?> benchmarks, boolean quick) {
        return new OptionsBuilder()
                .include(benchmarks.getName().replace(".", "\\.") + ".*")
                .forks(1)
                .warmupIterations(quick ? 2 : 5)
                .warmupTime(TimeValue.seconds(quick ? 1 : 2))
                .measurementIterations(quick ? 3 : 8)
                .measurementTime(TimeValue.seconds(quick ? 1 : 2))
                .build();
    }

    private static List<Figure> codec(boolean quick) throws RunnerException {
        List<Figure> figures = new ArrayList<>();
        for (RunResult result : new Runner(options(CodecBenchmarks.class, quick)).run()) {
            Result<?> primary = result.getPrimaryResult();
            double error = primary.getScoreError();
            figures.add(new Figure(
                    PREFIX + "codec",
                    Map.of(),
                    primary.getScore(),
                    "messages/s, written and read",
                    Double.isNaN(error) ? 0 : error));
        }
        return figures;
    }
}
