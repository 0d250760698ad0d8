package org.sami.crw.sim.bench;

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
 * Runs the benchmarks of the link, of the services and of hours of a run, prints a table and puts it into the file of all benchmarks. System properties: {@code
 * benchmarks.file}; {@code quick} = true for less than two minutes.
 */
public final class LinkBenchmarkMain {
    private static final String PREFIX = "link.";
    private static final String SERVICES = "service.";
    private static final String HEAP = "heap.growth";
    private static final String JOURNAL = "journal.growth";

    private LinkBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        boolean quick = Boolean.getBoolean("quick");
        List<Figure> figures = new ArrayList<>();
        figures.addAll(codec(quick));
        figures.addAll(new FleetBenchmark(250, quick ? 4 : 10, quick ? 8 : 30).run());
        figures.addAll(new UploadBenchmark(10_000, quick ? 5 : 25).run());
        FigureFile.print(figures);
        Path file = FigureFile.ofThisBuild();
        FigureFile.replace(file, PREFIX, figures);
        List<Figure> services = services(quick);
        FigureFile.print(services);
        FigureFile.replace(file, SERVICES, services);
        List<Figure> growth = new GrowthBenchmark(25, quick ? 3 : 100).run();
        FigureFile.print(growth);
        FigureFile.replace(file, HEAP, growth.subList(0, 1));
        FigureFile.replace(file, JOURNAL, growth.subList(1, 2));
        System.out.println("Written to " + file);
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
