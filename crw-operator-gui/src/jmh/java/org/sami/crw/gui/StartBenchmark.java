package org.sami.crw.gui;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.PaintEvent;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.crw.sim.bench.Figure;
import org.sami.crw.sim.bench.FigureFile;
import org.sami.ui.EventThread;

/** How long the program takes from the start of its process until its window with the built-in fleet is painted first. */
final class StartBenchmark {
    private static final String NAME = "window.start";
    private static final String WINDOW = "operator-window";

    private StartBenchmark() {}

    /**
     * Measures.
     *
     * @param args how many times; or {@code --data DIR} in a process that is measured, which says how many ms it took and ends
     */
    public static void main(String[] args) throws Exception {
        if (args.length == 1) {
            measure(Integer.parseInt(args[0]));
            return;
        }
        AtomicBoolean seen = new AtomicBoolean();
        Toolkit.getDefaultToolkit()
                .addAWTEventListener(
                        event -> {
                            if (event instanceof PaintEvent
                                    && event.getSource() instanceof Component component
                                    && WINDOW.equals(component.getName())
                                    && seen.compareAndSet(false, true)) {
                                EventThread.later(StartBenchmark::painted);
                            }
                        },
                        AWTEvent.PAINT_EVENT_MASK);
        OperatorGui.main(args);
    }

    private static void painted() {
        System.out.println(System.currentTimeMillis()
                - ManagementFactory.getRuntimeMXBean().getStartTime());
        Runtime.getRuntime().halt(0);
    }

    private static void measure(int times) throws Exception {
        List<Double> seconds = new ArrayList<>();
        for (int i = -1; i < times; i++) { // the first one fills the caches of the machine
            Path data = Files.createTempDirectory("window-start");
            Process process = WindowBenchmarkMain.java(StartBenchmark.class, "--data", data.toString())
                    .redirectError(ProcessBuilder.Redirect.INHERIT)
                    .start();
            String said = process.inputReader(StandardCharsets.UTF_8).readLine();
            process.waitFor();
            if (said == null) {
                throw new IllegalStateException("the window was not painted");
            }
            if (i >= 0) {
                seconds.add(Long.parseLong(said) / 1000.0);
            }
        }
        Collections.sort(seconds);
        double median = seconds.get(seconds.size() / 2);
        double most = seconds.get(seconds.size() - 1);
        List<Figure> figures = List.of(
                new Figure(NAME, Map.of("boats", 5), median, "s, process to first paint, median", most - median));
        FigureFile.print(figures);
        FigureFile.replace(WindowBenchmarkMain.file(), NAME, figures);
    }
}
