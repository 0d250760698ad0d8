package org.sami.ui.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.sami.ui.EventThread;
import org.sami.ui.map.HeavyFiles;
import org.sami.ui.map.MapKey;
import org.sami.ui.map.MapScenes;
import org.sami.ui.map.MapView;

/**
 * How long the event thread works without a pause while a large base map is read, and painted at other and other zooms: a task such as the fleet
 * stop's waits for as long. In processor time of that thread, which other work on the machine changes little: the median, and how much longer the
 * longest is.
 */
final class BaseMapFigures {
    private static final int EVERY_MS = 20;
    private static final int WARM_UP = 120;
    private static final int MOVES = 36;
    private static final int FRAMES_A_MOVE = 10;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final List<MapKey> KEYS =
            List.of(MapKey.FIT, MapKey.ZOOM_IN, MapKey.ZOOM_IN, MapKey.LEFT, MapKey.ZOOM_OUT, MapKey.ZOOM_OUT);

    private final int width;
    private final int height;
    private final NetEditingFigures.Figure taker;

    BaseMapFigures(int width, int height, NetEditingFigures.Figure taker) {
        this.width = width;
        this.height = height;
        this.taker = taker;
    }

    void run() throws IOException {
        Path folder = Files.createTempDirectory("base-maps");
        try {
            measure(
                    "map.base.line.busy",
                    "points",
                    2_000_000,
                    HeavyFiles.line(folder.resolve("line.geojson"), 2_000_000));
            measure(
                    "map.base.outlines.busy",
                    "outlines",
                    40_000,
                    HeavyFiles.outlines(folder.resolve("rocks.geojson"), 40_000));
        } finally {
            Files.deleteIfExists(folder.resolve("line.geojson"));
            Files.deleteIfExists(folder.resolve("rocks.geojson"));
            Files.deleteIfExists(folder);
        }
    }

    private void measure(String name, String what, int count, Path file) {
        MapView map = EventThread.get(() -> {
            MapView made = MapScenes.fleet(20, 1000);
            MapScenes.size(made, width, height);
            made.centre(MapScenes.LAKE);
            for (int i = 0; i < WARM_UP; i++) { // as a map that has been shown for a while
                made.press(KEYS.get(i % KEYS.size()));
                MapScenes.paint(made);
            }
            made.openBaseMap(file);
            return made;
        });
        List<Double> busy = new ArrayList<>();
        int moves = 0;
        for (int step = 0; moves < MOVES; step++) {
            boolean isMoved = step % FRAMES_A_MOVE == 0
                    && EventThread.get(() -> !map.baseMaps().isEmpty());
            MapKey key = KEYS.get(moves % KEYS.size());
            moves += isMoved ? 1 : 0;
            busy.add(EventThread.get(() -> {
                long before = THREADS.getCurrentThreadCpuTime();
                if (isMoved) {
                    map.press(key);
                }
                MapScenes.paint(map);
                return (THREADS.getCurrentThreadCpuTime() - before) / 1e6;
            }));
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(EVERY_MS));
        }
        EventThread.get(() -> {
            map.close();
            return map;
        });
        Collections.sort(busy);
        taker.take(name, new TreeMap<>(Map.of(what, count)), busy.get(busy.size() / 2), busy.get(busy.size() - 1));
    }
}
