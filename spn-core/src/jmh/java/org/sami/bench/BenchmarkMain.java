package org.sami.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.management.JMException;
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
 * Runs the benchmarks, prints a table and writes a file: an array of {@code name}, {@code params}, {@code value},
 * {@code unit}, {@code error}. System properties: {@code benchmarks.file}; {@code quick} = true for less than two minutes.
 */
public final class BenchmarkMain {
    private static final String ENGINE = "engine.";
    private static final String EDIT = "edit.";

    private final List<Figure> figures = new ArrayList<>();

    private BenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws RunnerException, IOException, JMException {
        new BenchmarkMain().run();
    }

    private void run() throws RunnerException, IOException, JMException {
        double bytes = MissionMemory.bytesPerIdleMission();
        Collection<RunResult> all = new Runner(options(Boolean.getBoolean("quick"))).run();
        for (RunResult r : all) {
            add(r);
        }
        figures.add(new Figure(ENGINE + "memory", Map.of("boats", 10), bytes, "bytes/mission", 0));
        FigureFile.print(figures);
        for (String subject : List.of(ENGINE, EDIT)) {
            List<Figure> own = figures.stream()
                    .filter(figure -> figure.name().startsWith(subject))
                    .toList();
            FigureFile.replace(FigureFile.ofThisBuild(), subject, own);
        }
        System.out.println("Written to " + FigureFile.ofThisBuild());
    }

    private static Options options(boolean quick) {
        return new OptionsBuilder()
                .include("org\\.sami\\.bench\\..*Benchmarks.*")
                .forks(1)
                .warmupIterations(quick ? 2 : 5)
                .warmupTime(TimeValue.seconds(quick ? 1 : 2))
                .measurementIterations(quick ? 4 : 8)
                .measurementTime(TimeValue.seconds(quick ? 1 : 2))
                // collector and room of crw (gradle/start.sh)
                .jvmArgs("-XX:+UseSerialGC", "-Xmn300m", "-Xms1g", "-Xmx1g")
                .build();
    }

    private void add(RunResult r) {
        Map<String, Integer> params = new TreeMap<>();
        for (String key : r.getParams().getParamsKeys()) {
            params.put(key, Integer.parseInt(r.getParams().getParam(key)));
        }
        String method = r.getParams().getBenchmark().replaceAll(".*\\.", "");
        String name = method.startsWith("proxies") ? "proxies" : method;
        switch (method) {
            case "proxiesByBoats" -> params.put("missions", 1);
            case "proxiesByMissions" -> params.put("boats", 10);
            default -> {}
        }
        Result<?> primary = r.getPrimaryResult();
        boolean time = primary.getScoreUnit().startsWith("us");
        double error = primary.getScoreError();
        String subject = r.getParams().getBenchmark().contains("EditBenchmarks") ? EDIT : ENGINE;
        String unit = time ? "us" : "events/s";
        figures.add(new Figure(subject + name, params, primary.getScore(), unit, Double.isNaN(error) ? 0 : error));
    }
}
