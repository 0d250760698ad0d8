package org.sami.ui.bench;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.figures.Figure;
import org.sami.figures.FigureFile;
import org.sami.palette.ProxyMarks;
import org.sami.palette.Theme;
import org.sami.picture.net.NetMode;
import org.sami.spn.model.Plan;
import org.sami.ui.look.Look;
import org.sami.ui.map.MapKey;
import org.sami.ui.map.MapScenes;
import org.sami.ui.map.MapView;
import org.sami.ui.map.MovingFleet;
import org.sami.ui.net.NetKey;
import org.sami.ui.net.NetView;
import org.sami.ui.net.WidePlan;

/**
 * Paints a map and nets of 1600 by 1000 pixels in software, prints the median of each and puts it into the file of all benchmarks. System
 * properties: {@code benchmarks.file}; {@code quick} = true for a few seconds.
 */
public final class RepaintBenchmarkMain {
    private static final String PREFIX = "repaint.";
    private static final int WIDTH = 1600;
    private static final int HEIGHT = 1000;

    private final int times = Boolean.getBoolean("quick") ? 150 : 600;
    private final List<Figure> figures = new ArrayList<>();

    private RepaintBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws IOException {
        new RepaintBenchmarkMain().run();
    }

    private void run() throws IOException {
        Look.apply(Theme.LIGHT, 100);
        for (int vehicles : new int[] {20, 250}) {
            MovingFleet fleet = new MovingFleet(vehicles, 1000);
            try (MapView map = fleet.map()) {
                MapScenes.size(map, WIDTH, HEIGHT);
                map.fitAll();
                SortedMap<String, Integer> params = new TreeMap<>(Map.of("vehicles", vehicles, "trackPoints", 1000));
                measure("map", params, map, fleet::move);
                AtomicBoolean left = new AtomicBoolean();
                measure(
                        "map.panned",
                        params,
                        map,
                        () -> map.press(left.getAndSet(!left.get()) ? MapKey.LEFT : MapKey.RIGHT));
            }
        }
        Plan plan = WidePlan.of(250);
        NetView net = new NetView(new ProxyMarks());
        net.setMode(NetMode.ALL);
        net.setSize(WIDTH, HEIGHT);
        net.doLayout();
        long before = System.nanoTime();
        net.show(plan, WidePlan.NO_VOCABULARY);
        figure("net.show", new TreeMap<>(Map.of("vertices", 500)), (System.nanoTime() - before) / 1e6, 0);
        measure("net.whole", new TreeMap<>(Map.of("vertices", 500)), net, () -> {});
        net.press(NetKey.ACTUAL_SIZE);
        measure("net.part", new TreeMap<>(Map.of("vertices", 500)), net, () -> {});
        new NetEditingFigures(times, WIDTH, HEIGHT, this::figure).run();
        new BaseMapFigures(WIDTH, HEIGHT, this::figure).run();
        FigureFile.print(figures);
        FigureFile.replace(FigureFile.ofThisBuild(), PREFIX, figures);
    }

    /** How long a component is painted after something was changed, without the change. */
    private void measure(String name, SortedMap<String, Integer> params, Component component, Runnable change) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        double[] ms = new double[times];
        for (int i = -times / 3; i < times; i++) { // the first ones warm up
            change.run();
            Graphics2D g = image.createGraphics();
            long before = System.nanoTime();
            component.paint(g);
            if (i >= 0) {
                ms[i] = (System.nanoTime() - before) / 1e6;
            }
            g.dispose();
        }
        Arrays.sort(ms);
        figure(name, params, ms[times / 2], ms[times * 95 / 100]);
    }

    private void figure(String name, SortedMap<String, Integer> params, double median, double p95) {
        figures.add(new Figure(PREFIX + name, params, median, "ms, median", Math.max(0, p95 - median)));
    }
}
