package org.sami.crw.gui;

import java.awt.SecondaryLoop;
import java.awt.Toolkit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.sim.bench.EndlessRun;
import org.sami.crw.sim.run.InProcessRun;
import org.sami.crw.sim.run.Pacer;
import org.sami.crw.sim.run.RunObserver;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.palette.Theme;
import org.sami.spn.testing.TemporaryFolder;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

/**
 * How the live heap grows while the window shows a fleet that keeps its stations for hours, as fast as it goes: world and window share the event
 * thread, and the window has its turn every few simulated seconds.
 */
final class WindowGrowthBenchmark {
    private static final String NAME = "window.heap";
    private static final long SHOW_MILLIS = 5_000;
    private static final int SAMPLES = 16;

    private final int boats;
    private final int hours;
    private final List<double[]> samples = new ArrayList<>(); // hours, MiB
    private long shownMillis;

    private WindowGrowthBenchmark(int boats, int hours) {
        this.boats = boats;
        this.hours = hours;
    }

    /**
     * Measures.
     *
     * @param args boats, hours
     */
    public static void main(String[] args) throws Exception {
        WindowGrowthBenchmark benchmark =
                new WindowGrowthBenchmark(Integer.parseInt(args[0]), Integer.parseInt(args[1]));
        CompletableFuture<Void> over = new CompletableFuture<>();
        EventThread.later(() -> {
            try {
                benchmark.run();
                over.complete(null);
            } catch (Exception | AssertionError fault) {
                over.completeExceptionally(fault);
            }
        });
        over.get();
        System.exit(0);
    }

    private void run() throws Exception {
        Look.apply(Theme.LIGHT, 100);
        System.out.printf(Locale.ROOT, "%n%8s %10s%n", "hours", "heap MiB");
        try (TemporaryFolder folder = new TemporaryFolder("window-growth");
                EndlessRun endless = new EndlessRun(boats, hours, folder.path().resolve("growth.journal"))) {
            InProcessRun run = endless.run();
            DataDirectory data = DataDirectory.open(folder.path().resolve("data"));
            new OperatorWindow(run.session(), Optional.empty(), data, new WindowSettings(data.settings()), code -> {})
                    .open();
            run.run(new WindowsTurn(), RunObserver.NONE);
            sample(hours * EndlessRun.HOUR_MS);
        }
        double[] first = samples.get(SAMPLES / 8);
        double[] last = samples.get(samples.size() - 1);
        Map<String, Integer> params = Map.of("boats", boats, "hours", hours);
        List<Figure> figures = List.of(
                new Figure(NAME, params, last[1], "MiB live at the end", 0),
                new Figure(NAME, params, (last[1] - first[1]) / (last[0] - first[0]), "MiB live per hour", 0));
        FigureFile.print(figures);
        FigureFile.replace(FigureFile.ofThisBuild(), NAME, figures);
    }

    /** Lets the window show what is so, every few simulated seconds. */
    private final class WindowsTurn implements Pacer {
        @Override
        public void start(long simulatedMillis) {
            shownMillis = simulatedMillis;
        }

        @Override
        public void awaitTurn(long simulatedMillis) {
            if (simulatedMillis - shownMillis >= SHOW_MILLIS) {
                shownMillis = simulatedMillis;
                show();
                if (simulatedMillis >= samples.size() * hours * EndlessRun.HOUR_MS / SAMPLES) {
                    sample((double) simulatedMillis);
                }
            }
        }
    }

    /** Serves what waits on the event thread, from within it. */
    private static void show() {
        SecondaryLoop loop = Toolkit.getDefaultToolkit().getSystemEventQueue().createSecondaryLoop();
        EventThread.later(() -> EventThread.later(loop::exit)); // what is painted is posted by what waits
        loop.enter();
    }

    private void sample(double simulatedMillis) {
        double[] sample = {simulatedMillis / EndlessRun.HOUR_MS, EndlessRun.liveHeapMiB()};
        samples.add(sample);
        System.out.printf(Locale.ROOT, "%8.2f %10.1f%n", sample[0], sample[1]);
    }
}
