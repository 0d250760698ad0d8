package org.sami.bench;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Locale;
import javax.management.JMException;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;

/**
 * Runs the benchmarks, prints a table and writes a file: an array of {@code name}, {@code params}, {@code value},
 * {@code unit}, {@code error}. System properties: {@code benchmarks.file}; {@code quick} = true for less than two minutes.
 */
public final class BenchmarkMain {
    private final ObjectMapper json = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);
    private final ArrayNode results = json.createArrayNode();

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
        add("engine.memory", json.createObjectNode().put("boats", 10), bytes, "bytes/mission", 0);
        print();
        Path file = Path.of(System.getProperty("benchmarks.file", "build/benchmarks.json"));
        keepWhatOthersMeasured(file);
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, json.writeValueAsString(results) + "\n");
        System.out.println("Written to " + file);
    }

    private void keepWhatOthersMeasured(Path file) throws IOException {
        if (Files.exists(file)) {
            for (JsonNode entry : json.readTree(file.toFile())) {
                String name = entry.path("name").asText();
                if (!name.startsWith("engine.") && !name.startsWith("edit.")) {
                    results.add(entry);
                }
            }
        }
    }

    private static Options options(boolean quick) {
        return new OptionsBuilder()
                .include("org\\.sami\\.bench\\..*Benchmarks.*")
                .forks(1)
                .warmupIterations(quick ? 2 : 5)
                .warmupTime(TimeValue.seconds(quick ? 1 : 2))
                .measurementIterations(quick ? 4 : 8)
                .measurementTime(TimeValue.seconds(quick ? 1 : 2))
                .jvmArgs("-Xms1g", "-Xmx1g")
                .build();
    }

    private void add(RunResult r) {
        ObjectNode params = json.createObjectNode();
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
        String subject = r.getParams().getBenchmark().contains("EditBenchmarks") ? "edit." : "engine.";
        add(subject + name, params, primary.getScore(), time ? "us" : "events/s", Double.isNaN(error) ? 0 : error);
    }

    private void add(String name, ObjectNode params, double value, String unit, double error) {
        ObjectNode entry = results.addObject();
        entry.put("name", name);
        entry.set("params", params);
        entry.put("value", value);
        entry.put("unit", unit);
        entry.put("error", error);
    }

    private void print() {
        System.out.println();
        System.out.printf(Locale.ROOT, "%-18s %-32s %16s %14s %s%n", "name", "params", "value", "error", "unit");
        results.forEach(r -> System.out.printf(
                Locale.ROOT,
                "%-18s %-32s %16.1f %14.1f %s%n",
                r.get("name").asText(),
                r.get("params").toString(),
                r.get("value").asDouble(),
                r.get("error").asDouble(),
                r.get("unit").asText()));
    }
}
