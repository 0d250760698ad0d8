package org.sami.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
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
 * {@code unit}, {@code error}. System properties: {@code benchmarks.file}; {@code quick} = true for less than two minutes; {@code only} = the name of one
 * benchmark, or how the names of several begin.
 */
public final class BenchmarkMain {
    private static final String ENGINE = "engine.";
    private static final String EDIT = "edit.";
    private static final String MEMORY = ENGINE + "memory";
    private static final String ONLY = System.getProperty("only", "");

    private final List<Figure> figures = new ArrayList<>();

    private BenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws RunnerException, IOException, JMException {
        new BenchmarkMain().run();
    }

    private void run() throws RunnerException, IOException, JMException {
        if (MEMORY.startsWith(ONLY)) {
            double bytes = MissionMemory.bytesPerIdleMission();
            figures.add(new Figure(MEMORY, Map.of("boats", 10), bytes, "bytes/mission", 0));
        }
        if (!ONLY.equals(MEMORY)) {
            new Runner(options(Boolean.getBoolean("quick"))).run().forEach(this::add);
        }
        FigureFile.print(figures);
        for (String subject : ONLY.isEmpty() ? List.of(ENGINE, EDIT) : List.of(ONLY)) {
            List<Figure> own = figures.stream()
                    .filter(figure -> figure.name().startsWith(subject))
                    .toList();
            FigureFile.replace(FigureFile.ofThisBuild(), subject, own);
        }
        System.out.println("Written to " + FigureFile.ofThisBuild());
    }

    private static Options options(boolean quick) {
        return new OptionsBuilder()
                .include("org\\.sami\\.bench\\." + included())
                .forks(1)
                .warmupIterations(quick ? 2 : 5)
                .warmupTime(TimeValue.seconds(quick ? 1 : 2))
                .measurementIterations(quick ? 4 : 8)
                .measurementTime(TimeValue.seconds(quick ? 1 : 2))
                // collector and room of crw (gradle/start.sh)
                .jvmArgs("-XX:+UseSerialGC", "-Xmn300m", "-Xms1g", "-Xmx1g")
                .build();
    }

    /** The classes and methods that are measured, as a regular expression: a method has its benchmark's name, or one that begins so. */
    private static String included() {
        int dot = ONLY.indexOf('.');
        if (dot < 0) {
            return ".*Benchmarks.*";
        }
        String classes = (ONLY + ".").startsWith(EDIT) ? "EditBenchmarks" : "(?!EditBenchmarks).*Benchmarks";
        return classes + "\\." + Pattern.quote(ONLY.substring(dot + 1)) + ".*";
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
