package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.ui.EventThread;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.base.BaseSource;
import org.sami.ui.map.base.BaseStyle;
import org.sami.ui.map.base.MbTiles;
import org.sami.ui.map.base.NamedPoint;
import org.sami.ui.map.base.TileKey;

/** Tiles of a base map as they are shown: what is there is painted, and nobody waits for the rest. */
class BaseTilesTest {
    private static final int LEVEL = 14;
    private static final int X = 8680;
    private static final int Y = 5835;

    @TempDir
    Path folder;

    @Test
    void theMapNamesABrokenFileAndGoesOn() throws Exception {
        Path broken =
                Files.writeString(folder.resolve("shore.geojson"), "{\"type\":\"LineString\",\"coordinates\":[[10]]}");
        CompletableFuture<String> problem = new CompletableFuture<>();
        try (MapView map = MapScenes.fleet(2, 50)) {
            MapScenes.size(map, 600, 400);
            map.addMapListener(new MapListener() {
                @Override
                public void problem(String text) {
                    problem.complete(text);
                }
            });

            map.openBaseMap(broken);

            assertThat(problem.get(60, TimeUnit.SECONDS))
                    .contains(broken.toString())
                    .contains("[longitude, latitude]");
            assertThat(MapScenes.paint(map).getWidth()).isEqualTo(600);
        }
    }

    @Test
    void paintsTilesWhenTheyHaveCome() throws Exception {
        try (BaseTiles tiles = tiles(lake())) {
            assertThat(paintedAfterReading(tiles, LEVEL, X, Y)).isEqualTo(Color.ORANGE);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {15, 17, 20, 22})
    void imageryIsStretchedPastItsLastLevel(int level) throws Exception {
        int finer = 1 << (level - LEVEL);
        try (BaseTiles tiles = tiles(lake())) {
            assertThat(paintedAfterReading(tiles, level, X * finer + finer / 2, Y * finer + finer / 3))
                    .isEqualTo(Color.ORANGE);
        }
    }

    @Test
    void imageryOfTheWholeWorldIsStretchedToTheNearestZoom() throws Exception {
        Path world = HeavyFiles.tiles(folder.resolve("world.mbtiles"), 3, 4, 2, png(Color.ORANGE), "");
        try (BaseTiles tiles = tiles(MbTiles.open(world))) {
            assertThat(paintedAfterReading(tiles, 22, (4 << 19) + 70_000, (2 << 19) + 300_000))
                    .isEqualTo(Color.ORANGE);
        }
    }

    @Test
    void aSlowFileHoldsNobodyUp() throws Exception {
        SlowTiles source = new SlowTiles();
        try (BaseTiles tiles = tiles(source)) {
            assertThat(colour(paint(tiles, LEVEL, X, Y)))
                    .isEqualTo(Color.BLACK); // comes back although nothing was read
            assertThat(onEventThread(tiles::isReading)).isTrue();
            source.released.countDown();
            assertThat(paintedAfterReading(tiles, LEVEL, X, Y)).isEqualTo(Color.GREEN);
        }
    }

    @Test
    void tilesThatAreNoLongerSeenAreNoLongerAskedFor() throws Exception {
        SlowTiles source = new SlowTiles();
        try (BaseTiles tiles = tiles(source)) {
            paint(tiles, LEVEL, X, Y);
            assertThat(source.asked.await(60, TimeUnit.SECONDS)).isTrue();
            for (int east = 1; east <= 40; east++) {
                paint(tiles, LEVEL, X + 10 * east, Y);
            }
            source.released.countDown();
            paintedAfterReading(tiles, LEVEL, X + 400, Y);

            assertThat(source.count.get()).as("tiles that were read").isLessThan(20);
        }
    }

    @Test
    void tilesThatCameWhileTheEventThreadWasBusyAreOneTaskForIt() throws Exception {
        SlowTiles source = new SlowTiles();
        source.released.countDown();
        try (BaseTiles tiles = tiles(source)) {
            onEventThread(() -> {
                Graphics2D g = new BufferedImage(10, 10, BufferedImage.TYPE_INT_RGB).createGraphics();
                tiles.paint(g, new MapFrame(0.5, 0.5, Math.scalb(256.0, LEVEL), 8 * 256, 5 * 256));
                g.dispose();
                while (source.count.get() < 40) {
                    Thread.onSpinWait();
                }
                return tiles;
            });
            while (onEventThread(tiles::isReading)) {
                Thread.onSpinWait();
            }

            assertThat(source.count.get()).isBetween(40, 54); // each tile once
            assertThat(come.size()).as("tasks of the event thread").isLessThan(16);
        }
    }

    @Test
    void closingLeavesATileThatIsBeingRead() throws Exception {
        SlowTiles source = new SlowTiles();
        BaseTiles tiles = tiles(source);
        paint(tiles, LEVEL, X, Y);
        assertThat(source.asked.await(60, TimeUnit.SECONDS)).isTrue();

        tiles.close();

        assertThat(source.closed.await(60, TimeUnit.SECONDS))
                .as("the source is closed, although a tile was being read")
                .isTrue();
        assertThat(colour(paint(tiles, LEVEL, X + 1, Y))).isEqualTo(Color.BLACK);
    }

    /** Tiles that are not read before they are released. */
    private static final class SlowTiles implements BaseSource {
        private final CountDownLatch asked = new CountDownLatch(1);
        private final CountDownLatch released = new CountDownLatch(1);
        private final CountDownLatch closed = new CountDownLatch(1);
        private final AtomicInteger count = new AtomicInteger();

        @Override
        public String name() {
            return "slow";
        }

        @Override
        public String attribution() {
            return "";
        }

        @Override
        public Optional<GeoBounds> bounds() {
            return Optional.empty();
        }

        @Override
        public boolean isImagery() {
            return true;
        }

        @Override
        public Optional<String> restriction() {
            return Optional.empty();
        }

        @Override
        public double tileScale(double worldPx) {
            return worldPx;
        }

        @Override
        public OptionalDouble coarser(double tileScale) {
            return OptionalDouble.empty();
        }

        @Override
        public List<NamedPoint> names(MapFrame frame, int most) {
            return List.of();
        }

        @Override
        public Optional<BufferedImage> tile(TileKey key, BaseStyle style) throws IOException {
            asked.countDown();
            count.incrementAndGet();
            try {
                released.await();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IOException(e);
            }
            return Optional.of(picture(Color.GREEN));
        }

        @Override
        public void close() {
            closed.countDown();
        }
    }

    private final BlockingQueue<String> come = new LinkedBlockingQueue<>();

    private BaseTiles tiles(BaseSource source) {
        return onEventThread(() -> new BaseTiles(source, true, () -> come.add("come"), () -> {}, come::add));
    }

    /** The colour of a tile's middle once it has been read. */
    private Color paintedAfterReading(BaseTiles tiles, int level, int x, int y) throws Exception {
        BufferedImage image = paint(tiles, level, x, y);
        while (colour(image).equals(Color.BLACK)) {
            assertThat(come.poll(60, TimeUnit.SECONDS)).isEqualTo("come");
            image = paint(tiles, level, x, y);
        }
        return colour(image);
    }

    private static BufferedImage paint(BaseTiles tiles, int level, int x, int y) {
        BufferedImage image = new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB);
        double across = Math.scalb(1.0, level);
        MapFrame frame = new MapFrame((x + 0.49) / across, (y + 0.49) / across, 256 * across, 252, 252);
        return onEventThread(() -> {
            Graphics2D g = image.createGraphics();
            tiles.paint(g, frame);
            g.dispose();
            return image;
        });
    }

    private static <T> T onEventThread(Supplier<T> work) {
        return EventThread.isCurrent() ? work.get() : EventThread.get(work);
    }

    private static Color colour(BufferedImage image) {
        return new Color(image.getRGB(200, 100));
    }

    private static BufferedImage picture(Color color) {
        BufferedImage image = new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(color);
        g.fillRect(0, 0, 256, 256);
        g.dispose();
        return image;
    }

    private static byte[] png(Color color) throws IOException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(picture(color), "png", png);
        return png.toByteArray();
    }

    /** A file with one orange tile. */
    private BaseSource lake() throws Exception {
        return MbTiles.open(HeavyFiles.tiles(folder.resolve("lake.mbtiles"), LEVEL, X, Y, png(Color.ORANGE), ""));
    }
}
