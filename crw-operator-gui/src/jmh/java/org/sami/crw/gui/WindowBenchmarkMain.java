package org.sami.crw.gui;

import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.ui.check.StartBenchmark;

/**
 * Measures the operator's window, each measurement in a process of its own, prints tables and puts them into the file of all benchmarks. System
 * properties: {@code benchmarks.file}; {@code quick} = true for less than two minutes; {@code window.install} says how to get a display.
 */
public final class WindowBenchmarkMain {
    private static final List<String> FLAGS =
            List.of("-XX:+UseSerialGC", "-Xshare:auto", "-Xmx1g"); // as the program has them

    private WindowBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws Exception {
        if (GraphicsEnvironment.isHeadless()) {
            System.out.println("The window is not measured, for there is no display; get one by: "
                    + System.getProperty("window.install"));
            return;
        }
        boolean quick = Boolean.getBoolean("quick");
        start(quick ? 3 : 10);
        run(LatencyBenchmark.class, "250", "50", quick ? "15" : "60");
        run(LatencyBenchmark.class, "25", "5", quick ? "10" : "60", "ours");
        run(LatencyBenchmark.class, "25", "5", quick ? "10" : "60", "vehicles");
        run(WindowGrowthBenchmark.class, "25", quick ? "1" : "8");
    }

    private static void start(int times) throws Exception {
        Path script = Path.of(System.getProperty("installed.script"));
        List<Figure> figures =
                new StartBenchmark("window.start", script, OperatorGui.class, "operator-window").measure(times);
        FigureFile.print(figures);
        FigureFile.replace(FigureFile.ofThisBuild(), "window.start", figures);
    }

    /** Runs one measurement. */
    private static void run(Class<?> benchmark, String... args) throws Exception {
        int code = java(benchmark, args).inheritIO().start().waitFor();
        if (code != 0) {
            throw new IllegalStateException(benchmark.getSimpleName() + " ended with " + code);
        }
    }

    /** A process of the program's Java, with the class path of this one. */
    private static ProcessBuilder java(Class<?> main, String... args) {
        List<String> line = new ArrayList<>();
        line.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        line.addAll(FLAGS);
        line.add("-Dbenchmarks.file=" + FigureFile.ofThisBuild());
        line.addAll(List.of("-cp", System.getProperty("java.class.path"), main.getName()));
        line.addAll(Arrays.asList(args));
        return new ProcessBuilder(line);
    }
}
