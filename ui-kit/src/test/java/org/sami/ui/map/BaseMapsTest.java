package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.EventThread;
import org.sami.ui.geo.GeoBounds;

/** Base maps are layers: taken off and put on again, and none is lost because another one is wrong. */
class BaseMapsTest {
    private static final int WITHIN_S = 60;
    private static final String LAND = "{\"type\": \"Polygon\", \"coordinates\":"
            + " [[[10.7, 45.69], [10.74, 45.69], [10.74, 45.71], [10.7, 45.71], [10.7, 45.69]]]}";

    @TempDir
    private Path folder;

    private MapView map;
    private final List<String> problems = new CopyOnWriteArrayList<>();
    private final AtomicInteger changes = new AtomicInteger();

    @BeforeEach
    void open() {
        map = onEventThread(() -> {
            MapView made = new MapView();
            MapScenes.size(made, 400, 300);
            made.setGrid(false);
            made.centre(MapScenes.LAKE);
            made.addMapListener(new MapListener() {
                @Override
                public void problem(String text) {
                    problems.add(text);
                }

                @Override
                public void baseMapsChanged() {
                    changes.incrementAndGet();
                }
            });
            return made;
        });
    }

    @AfterEach
    void close() {
        run(map::close);
    }

    private Path land(String name) throws IOException {
        return Files.writeString(folder.resolve(name), LAND);
    }

    private Path imagery(String name, Color color) throws Exception {
        BufferedImage image = new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(color);
        g.fillRect(0, 0, 256, 256);
        g.dispose();
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return HeavyFiles.tiles(folder.resolve(name), 3, 4, 2, png.toByteArray(), "");
    }

    @Test
    void aBaseMapIsTakenOffAndPutOnAgain() throws Exception {
        int water = middle();
        Path land = land("shore.geojson");
        run(() -> map.openBaseMap(land));
        until("land is seen", () -> middle() != water);
        assertThat(map.baseMaps()).containsExactly(new BaseMapState(land, "shore.geojson", true, ""));

        run(() -> map.setBaseMap(land, false));
        assertThat(middle()).isEqualTo(water);
        assertThat(map.baseMaps()).containsExactly(new BaseMapState(land, "shore.geojson", false, ""));

        run(() -> map.setBaseMap(land, true));
        until("land is seen again", () -> middle() != water);

        run(() -> map.forgetBaseMap(land));
        assertThat(middle()).isEqualTo(water);
        assertThat(map.baseMaps()).isEmpty();
        assertThat(changes.get()).isEqualTo(4);
    }

    @Test
    void theMapThatWasShownStaysWhenItsFileIsWrongTheNextTime() throws Exception {
        int water = middle();
        Path land = land("shore.geojson");
        run(() -> map.openBaseMap(land));
        until("land is seen", () -> middle() != water);
        Files.writeString(land, LAND.substring(0, LAND.length() - 20));

        run(() -> map.openBaseMap(land));
        until("it is told what is wrong", () -> !problems.isEmpty());

        assertThat(problems.get(0)).contains(land.toString()).contains("line 1, column");
        assertThat(middle()).isNotEqualTo(water);
        assertThat(map.baseMaps()).containsExactly(new BaseMapState(land, "shore.geojson", true, ""));
    }

    @Test
    void aMapThatIsNotThereNowStaysOnTheListAndIsReadWhenItIsThere() throws Exception {
        Path stick = folder.resolve("stick.geojson");
        run(() -> map.restoreBaseMap(stick, true));
        until("it is told what is wrong", () -> !problems.isEmpty());

        assertThat(map.baseMaps())
                .containsExactly(new BaseMapState(stick, "stick.geojson", true, "There is no map file " + stick));

        Files.writeString(stick, LAND);
        run(() -> map.setBaseMap(stick, true));
        until("it is shown", () -> map.layers().find("base-stick.geojson").isPresent());
        assertThat(map.baseMaps()).containsExactly(new BaseMapState(stick, "stick.geojson", true, ""));
    }

    @Test
    void aClickOnTheMapTakesAwayWhatWasSaidOfAFile() throws Exception {
        run(() -> map.openBaseMap(folder.resolve("gone.geojson")));
        until("it is told what is wrong", () -> !problems.isEmpty());
        MapCanvas canvas = (MapCanvas) map.canvas();
        assertThat(canvas.said()).isEqualTo(problems.get(0));

        for (int id : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
            run(() -> canvas.dispatchEvent(
                    new MouseEvent(canvas, id, 0, MouseEvent.BUTTON1_DOWN_MASK, 50, 50, 1, false, MouseEvent.BUTTON1)));
        }

        assertThat(canvas.said()).isEmpty();
    }

    @Test
    void aMapThatWasOffIsReadOnlyWhenItIsPutOn() throws Exception {
        Path land = land("shore.geojson");
        run(() -> map.restoreBaseMap(land, false));

        assertThat(map.stopReading().whyNot()).contains("no map file is being read");
        assertThat(map.baseMaps()).containsExactly(new BaseMapState(land, "shore.geojson", false, ""));

        run(() -> map.setBaseMap(land, true));
        until("it is shown", () -> map.layers().find("base-shore.geojson").isPresent());
    }

    @Test
    void imageryLiesBelowOutlinesAndOneHidesAnother() throws Exception {
        Path green = imagery("green.mbtiles", Color.GREEN);
        Path red = imagery("red.mbtiles", Color.RED);
        Path land = land("shore.geojson");
        run(() -> map.openBaseMap(green));
        until("imagery is seen", () -> middle() == Color.GREEN.getRGB());
        run(() -> map.openBaseMap(land));
        until("land is seen", () -> middle() != Color.GREEN.getRGB());
        run(() -> map.openBaseMap(red));
        until("the other imagery is seen", () -> corner() == Color.RED.getRGB());

        assertThat(middle()).isNotEqualTo(Color.RED.getRGB());
        assertThat(map.baseMaps()).extracting(BaseMapState::on).containsExactly(false, true, true);
        run(() -> map.setBaseMap(green, true));
        until("imagery is seen again", () -> corner() == Color.GREEN.getRGB());
        assertThat(map.baseMaps()).extracting(BaseMapState::on).containsExactly(true, true, false);
    }

    @Test
    void anotherMapShowsTheSameWithoutReadingTheFileAgain() throws Exception {
        Path land = land("shore.geojson");
        Path green = imagery("green.mbtiles", Color.GREEN);
        run(() -> map.openBaseMap(land));
        run(() -> map.openBaseMap(green));
        until("both are read", () -> map.baseMaps().size() == 2);
        Files.delete(land);
        MapView first = map;
        MapView small = onEventThread(() -> {
            MapView made = new MapView();
            MapScenes.size(made, 400, 300);
            made.centre(MapScenes.LAKE);
            made.showBaseMapsOf(first);
            made.showBaseMapsOf(first);
            return made;
        });

        until("the small one shows land", () -> MapScenes.paint(small).getRGB(200, 140) == middle());
        assertThat(small.baseMaps()).extracting(BaseMapState::file).containsExactlyInAnyOrder(land, green);

        run(() -> {
            first.setBaseMap(land, false);
            small.showBaseMapsOf(first);
        });
        until("it shows imagery only", () -> MapScenes.paint(small).getRGB(200, 140) == Color.GREEN.getRGB());
        run(small::close);
        run(() -> first.setBaseMap(land, true));
        run(() -> first.press(MapKey.ZOOM_IN));
        until("the first one goes on", () -> middle() != Color.GREEN.getRGB());
    }

    @Test
    void showingAllShowsABaseMapOnlyWhereThereIsNothingElse() throws Exception {
        run(() -> map.openBaseMap(land("shore.geojson")));
        until("it is a layer", () -> map.layers().find("base-shore.geojson").isPresent());
        run(() -> map.fitAll());
        double metres = onEventThread(() -> map.frame().metresPerPixel());

        run(() -> {
            AreaLayer areas = map.layers().add(new AreaLayer("areas", "Areas"));
            areas.show(List.of(new ShownArea("a", "a", MapScenes.square(0, 0, 20), ShownArea.Kind.WORK)));
            map.fitAll();
        });

        assertThat(metres).isGreaterThan(5);
        assertThat(onEventThread(() -> map.frame().metresPerPixel())).isLessThan(1);
        assertThat(onEventThread(() -> map.layers().bounds()))
                .hasValueSatisfying(box -> assertThat(box).isNotEqualTo(new GeoBounds(45.69, 10.7, 45.71, 10.74)));
    }

    private interface Work {
        void run() throws Exception;
    }

    private static void run(Work work) {
        onEventThread(() -> {
            try {
                work.run();
            } catch (Exception fault) {
                throw new IllegalStateException(fault);
            }
            return true;
        });
    }

    private int middle() {
        return onEventThread(() -> MapScenes.paint(map).getRGB(200, 140));
    }

    private int corner() {
        return onEventThread(() -> {
            map.centre(MapScenes.at(0, 20_000));
            int colour = MapScenes.paint(map).getRGB(200, 140);
            map.centre(MapScenes.LAKE);
            return colour;
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
