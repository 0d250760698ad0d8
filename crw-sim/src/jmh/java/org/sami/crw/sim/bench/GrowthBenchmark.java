package org.sami.crw.sim.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunObserver;
import org.sami.figures.Figure;

/**
 * How the live heap and the journal grow while a fleet keeps its stations for hours, as fast as it goes; the operator never ends it.
 */
final class GrowthBenchmark {
    private static final double MEBIBYTE = 1 << 20;

    private final int boats;
    private final int hours;

    /** What was there after so many simulated hours. */
    private record Sample(double hours, double heapMiB, double journalMiB) {}

    GrowthBenchmark(int boats, int hours) {
        this.boats = boats;
        this.hours = hours;
    }

    /** MiB that heap and journal grow each simulated hour, from the first tenth of the time on. */
    List<Figure> run() throws IOException {
        Path folder = Files.createTempDirectory("growth");
        List<Sample> samples = new ArrayList<>();
        try {
            run(folder.resolve("growth.journal"), samples);
        } finally {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
        Sample first = samples.get(Math.max(0, samples.size() / 10 - 1));
        Sample last = samples.get(samples.size() - 1);
        double between = last.hours - first.hours;
        Map<String, Integer> params = Map.of("boats", boats, "hours", hours);
        return List.of(
                new Figure("heap.growth", params, (last.heapMiB - first.heapMiB) / between, "MiB live per hour", 0),
                new Figure(
                        "journal.growth", params, (last.journalMiB - first.journalMiB) / between, "MiB per hour", 0));
    }

    private void run(Path file, List<Sample> samples) throws IOException {
        System.out.printf(Locale.ROOT, "%n%8s %10s %12s%n", "hours", "heap MiB", "journal MiB");
        try (EndlessRun endless = new EndlessRun(boats, hours, file)) {
            InProcessRun run = endless.run();
            double everyHours = Math.max(1, hours / 20.0);
            run.addListener((index, atMillis, input, effects, view) -> {
                if (atMillis / EndlessRun.HOUR_MS >= (samples.size() + 1) * everyHours) {
                    samples.add(sample(atMillis / EndlessRun.HOUR_MS, file));
                }
            });
            RunReport report = run.run(Pacer.UNPACED, RunObserver.NONE);
            samples.add(sample(report.result().simulatedMillis() / EndlessRun.HOUR_MS, file));
            System.out.printf(
                    Locale.ROOT,
                    "%d firings in %.0f s%n",
                    report.result().firings(),
                    report.result().wallSeconds());
        }
    }

    private static Sample sample(double hours, Path journal) {
        Sample sample = new Sample(hours, EndlessRun.liveHeapMiB(), size(journal) / MEBIBYTE);
        System.out.printf(Locale.ROOT, "%8.1f %10.1f %12.1f%n", sample.hours, sample.heapMiB, sample.journalMiB);
        return sample;
    }

    /** Without the write-ahead log, whose size is bounded. */
    private static long size(Path journal) {
        try {
            return Files.size(journal);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
