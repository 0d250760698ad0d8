package org.sami.ui.bench;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.spn.model.Plan;
import org.sami.ui.look.IdentityMarks;
import org.sami.ui.look.Look;
import org.sami.ui.look.Theme;
import org.sami.ui.map.MapKey;
import org.sami.ui.map.MapScenes;
import org.sami.ui.map.MapView;
import org.sami.ui.map.MovingFleet;
import org.sami.ui.net.NetKey;
import org.sami.ui.net.NetMode;
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
    private static final ObjectMapper JSON = new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

    private final int times = Boolean.getBoolean("quick") ? 150 : 600;
    private final ArrayNode figures = JSON.createArrayNode();

    private RepaintBenchmarkMain() {}

    /** No arguments. */
    public static void main(String[] args) throws IOException {
        new RepaintBenchmarkMain().run();
    }

    private void run() throws IOException {
        Look.apply(Theme.LIGHT, 100);
        System.out.printf(Locale.ROOT, "%n%-22s %-34s %10s %10s %s%n", "name", "params", "median", "p95", "unit");
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
        NetView net = new NetView(new IdentityMarks());
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
        write(Path.of(System.getProperty("benchmarks.file", "build/benchmarks.json")));
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
        ObjectNode entry = figures.addObject().put("name", PREFIX + name);
        ObjectNode with = entry.putObject("params");
        params.forEach(with::put);
        entry.put("value", median).put("unit", "ms").put("error", Math.max(0, p95 - median));
        System.out.printf(Locale.ROOT, "%-22s %-34s %10.2f %10.2f ms%n", PREFIX + name, params, median, p95);
    }

    private void write(Path file) throws IOException {
        ArrayNode all = JSON.createArrayNode();
        if (Files.exists(file)) {
            for (JsonNode entry : JSON.readTree(file.toFile())) {
                if (!entry.path("name").asText().startsWith(PREFIX)) {
                    all.add(entry);
                }
            }
        }
        all.addAll(figures);
        Files.createDirectories(file.toAbsolutePath().getParent());
        Files.writeString(file, JSON.writeValueAsString(all) + "\n");
        System.out.println("Written to " + file);
    }
}
