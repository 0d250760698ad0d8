package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.EventThread;

/**
 * Map files that are large, dense or wrong: the event thread, which has to answer the fleet stop, is handed little work whatever a file
 * holds. The work is counted and not timed.
 */
@Tag("long")
class HeavyBaseMapTest {
    private static final int WITHIN_S = 120;
    private static final long MOST_WORK = 6_000; // painting a map of two vehicles without a base map is about 1,000

    @TempDir
    private Path folder;

    private MapView map;
    private final List<String> problems = new ArrayList<>();

    @BeforeEach
    void open() {
        map = onEventThread(() -> {
            MapView made = MapScenes.fleet(2, 50);
            MapScenes.size(made, 1600, 1000);
            made.centre(MapScenes.LAKE);
            made.addMapListener(new MapListener() {
                @Override
                public void problem(String text) {
                    problems.add(text);
                }
            });
            return made;
        });
    }

    @AfterEach
    void close() {
        onEventThread(() -> {
            map.close();
            return map;
        });
    }

    @Test
    void aLineOfTwoMillionPointsHandsTheEventThreadLittle() throws Exception {
        Path line = HeavyFiles.line(folder.resolve("line.geojson"), 2_000_000);

        open(line);
        untilShown("line.geojson");

        assertThatPaintingIsLittleWork();
    }

    @Test
    void fortyThousandOutlinesHandTheEventThreadLittleAtEachZoom() throws Exception {
        Path outlines = HeavyFiles.outlines(folder.resolve("rocks.geojson"), 40_000);

        open(outlines);
        untilShown("rocks.geojson");

        assertThatPaintingIsLittleWork();
    }

    @Test
    void aWrongFileOfTwentyMegabytesIsNamedInFewWords() throws Exception {
        Path wrong = HeavyFiles.wrongLine(folder.resolve("wrong.geojson"), 20_000_000);

        open(wrong);
        until("it is told what is wrong", () -> !problems.isEmpty());

        assertThat(problems.get(0)).contains(wrong.toString()).hasSizeLessThan(400);
        assertThatPaintingIsLittleWork();
    }

    @Test
    void anAttributionOfFiftyMegabytesIsCut() throws Exception {
        Path tiles = HeavyFiles.tiles(
                folder.resolve("named.mbtiles"), 14, 8680, 5835, new byte[0], "somebody ".repeat(5_800_000));

        open(tiles);
        until("it is told that it is cut", () -> !problems.isEmpty());

        assertThat(problems.get(0)).contains("named.mbtiles").contains("52,200,000");
        assertThatPaintingIsLittleWork();
    }

    private void assertThatPaintingIsLittleWork() {
        for (MapKey key : List.of(MapKey.FIT, MapKey.ZOOM_IN, MapKey.ZOOM_OUT, MapKey.ZOOM_OUT, MapKey.LEFT)) {
            onEventThread(() -> {
                map.press(key);
                return map;
            });
            assertThat(onEventThread(() -> PaintingWork.of(map)))
                    .as("what is painted on the event thread after %s", key.label())
                    .isLessThan(MOST_WORK);
        }
    }

    private void untilShown(String name) {
        until("it is a layer", () -> map.layers().find("base-" + name).isPresent());
    }

    private void open(Path file) {
        onEventThread(() -> {
            map.openBaseMap(file);
            return map;
        });
    }

    private static <T> T onEventThread(Supplier<T> work) {
        return EventThread.isCurrent() ? work.get() : EventThread.get(work);
    }

    private static void until(String what, BooleanSupplier so) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(WITHIN_S);
        while (!onEventThread(so::getAsBoolean)) {
            assertThat(System.nanoTime()).as(what).isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(5));
        }
    }
}
