package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.awt.Container;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.EventThread;
import org.sami.ui.check.Layout;
import org.sami.ui.map.base.MbTiles;

/** Map files that take for ever: the map names them, goes on, and leaves them when it is told to. */
@Timeout(value = 900, threadMode = ThreadMode.SEPARATE_THREAD) // who opens a pipe cannot be interrupted
class SlowBaseMapTest {
    private static final int WITHIN_S = 60;
    private static final String OUTLINE = "{\"type\": \"LineString\", \"coordinates\": [[10.7, 45.7], [10.8, 45.7]]}";

    @TempDir
    private Path folder;

    private MapView map;

    @BeforeEach
    void open() {
        map = onEventThread(() -> {
            MapView made = MapScenes.fleet(2, 50);
            Layout.layOut(made, 600, 400);
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
    void aFileThatIsNeverReadIsNamedOnTheMapUntilItIsLeft() throws Exception {
        Path never = SlowFiles.pipe(folder.resolve("shore.geojson"));

        open(never);
        until("it is named", () -> find("map-reading", JComponent.class).isVisible());
        assertThat(map.stopReading().whyNot()).isEmpty();
        assertThat(find("map-reading-file", JLabel.class).getText()).isEqualTo("Reading shore.geojson…");
        assertThat(onEventThread(() -> MapScenes.paint(map)).getWidth()).isEqualTo(600);

        onEventThread(() -> {
            find("map-base-stop", AbstractButton.class).doClick(0);
            return map;
        });

        assertThat(find("map-reading", JComponent.class).isVisible()).isFalse();
        assertThat(map.stopReading().whyNot()).contains("no map file is being read");
        assertThatIOException()
                .as("who reads the pipe gives it up")
                .isThrownBy(() -> Files.write(never, new byte[1 << 20]));
        assertThat(onEventThread(() -> map.layers().find("base-shore.geojson"))).isEmpty();
    }

    @Test
    void aFileThatTakesItsTimeIsShownInTheEnd() throws Exception {
        Path late = SlowFiles.pipe(folder.resolve("shore.geojson"));
        open(late);
        until("it is named", () -> find("map-reading", JComponent.class).isVisible());

        Files.write(late, OUTLINE.getBytes(StandardCharsets.UTF_8));

        until("it is a layer", () -> map.layers().find("base-shore.geojson").isPresent());
        until(
                "it is read no longer",
                () -> !find("map-reading", JComponent.class).isVisible());
    }

    @Test
    void aTableOfTilesWithoutAnEndIsLeft() throws Exception {
        Path endless = SlowFiles.endlessTiles(folder.resolve("endless.mbtiles"));

        Thread.currentThread().interrupt();
        assertThatIOException().isThrownBy(() -> MbTiles.open(endless)).withMessageContaining(endless.toString());

        assertThat(Thread.interrupted()).isTrue();
    }

    @Test
    void anotherMapOfTilesTakesThePlaceOfOneThatIsStillRead() throws Exception {
        open(SlowFiles.endlessTiles(folder.resolve("endless.mbtiles")));
        Path broken = Files.writeString(folder.resolve("broken.mbtiles"), "no database at all, but quickly read");

        open(broken);

        until("nothing is read", () -> map.stopReading().whyNot().isPresent());
    }

    private void open(Path file) {
        onEventThread(() -> {
            map.openBaseMap(file);
            return map;
        });
    }

    private <T extends Container> T find(String name, Class<T> type) {
        return Layout.find(map, name, type).orElseThrow();
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
