package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.ui.geo.GeoBounds;

class BaseMapTest {
    private static final int LEVEL = 14;
    private static final int X = 8680;
    private static final int Y = 5835;
    private static final int ZOOM = OfflineTiles.FINEST_LEVEL - LEVEL;

    @TempDir
    Path folder;

    @Test
    void readsTilesWhoseRowsAreCountedFromTheSouth() throws Exception {
        try (MbTiles tiles = MbTiles.open(mbtiles("lake.mbtiles", "png"))) {
            assertThat(tiles.name()).isEqualTo("Lake");
            assertThat(tiles.attribution()).isEqualTo("made by hand");
            assertThat(tiles.finestLevel()).isEqualTo(LEVEL);
            assertThat(tiles.bounds()).contains(new GeoBounds(45.6, 10.6, 45.8, 10.8));
            assertThat(colour(tiles.tile(LEVEL, X, Y).orElseThrow())).isEqualTo(Color.ORANGE);
            assertThat(tiles.tile(LEVEL, X, Y + 1)).isEmpty();
        }
    }

    @Test
    void namesAFileThatIsNoMap() throws Exception {
        Path text = Files.writeString(folder.resolve("notes.mbtiles"), "these are notes, and no database at all");
        Path gone = folder.resolve("gone.mbtiles");
        Path vector = mbtiles("vector.mbtiles", "pbf");

        assertThatIOException().isThrownBy(() -> MbTiles.open(text)).withMessageContaining(text.toString());
        assertThatIOException().isThrownBy(() -> MbTiles.open(gone)).withMessage("There is no map file " + gone);
        assertThatIOException().isThrownBy(() -> MbTiles.open(vector)).withMessageContaining("vector tiles");
    }

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
    void readsOutlines() throws Exception {
        Path file = Files.writeString(folder.resolve("shore.geojson"), """
                {"type": "FeatureCollection", "features": [
                  {"type": "Feature", "properties": {"name": "pier"}, "geometry": {"type": "Point", "coordinates": [10.72, 45.7]}},
                  {"type": "Feature", "properties": {}, "geometry": null},
                  {"type": "Feature", "properties": {}, "geometry": {"type": "GeometryCollection", "geometries": [
                    {"type": "MultiLineString", "coordinates": [[[10, 45], [11, 45]], [[10, 46], [11, 46, 3]]]},
                    {"type": "Polygon", "coordinates": [[[10, 45], [11, 45], [11, 46], [10, 45]]]}]}}]}
                """);

        GeoJson outlines = GeoJson.read(file);

        assertThat(outlines.points()).containsExactly(new GeoJson.NamedPoint("pier", MapScenes.LAKE));
        assertThat(outlines.lines()).hasSize(2);
        assertThat(outlines.polygons()).hasSize(1);
        assertThat(new OutlineLayer("shore", outlines).bounds()).contains(new GeoBounds(45, 10, 46, 11));
    }

    @Test
    void paintsTilesWhenTheyHaveCome() throws Exception {
        try (OfflineTiles tiles = tiles(MbTiles.open(mbtiles("lake.mbtiles", "png")))) {
            assertThat(paintedAfterReading(tiles, ZOOM, X, Y)).isEqualTo(Color.ORANGE);
        }
    }

    @Test
    void paintsAFinerLevelThanThereIsFromTheFinestOne() throws Exception {
        try (OfflineTiles tiles = tiles(MbTiles.open(mbtiles("lake.mbtiles", "png")))) {
            assertThat(paintedAfterReading(tiles, ZOOM - 3, X * 8 + 5, Y * 8 + 2))
                    .isEqualTo(Color.ORANGE);
        }
    }

    @Test
    void aSlowFileHoldsNobodyUp() throws Exception {
        SlowTiles source = new SlowTiles();
        try (OfflineTiles tiles = tiles(source)) {
            assertThat(colour(paint(tiles, ZOOM, X, Y))).isEqualTo(Color.BLACK); // comes back although nothing was read
            assertThat(tiles.isReading()).isTrue();
            source.released.countDown();
            assertThat(paintedAfterReading(tiles, ZOOM, X, Y)).isEqualTo(Color.GREEN);
        }
    }

    @Test
    void closingLeavesATileThatIsBeingRead() throws Exception {
        SlowTiles source = new SlowTiles();
        OfflineTiles tiles = tiles(source);
        paint(tiles, ZOOM, X, Y);
        assertThat(source.asked.await(60, TimeUnit.SECONDS)).isTrue();

        tiles.close();

        assertThat(source.closed.await(60, TimeUnit.SECONDS))
                .as("the source is closed, although a tile was being read")
                .isTrue();
        assertThat(colour(paint(tiles, ZOOM, X + 1, Y))).isEqualTo(Color.BLACK);
    }

    /** Tiles that are not read before they are released. */
    private static final class SlowTiles implements TileSource {
        private final CountDownLatch asked = new CountDownLatch(1);
        private final CountDownLatch released = new CountDownLatch(1);
        private final CountDownLatch closed = new CountDownLatch(1);

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
        public int finestLevel() {
            return LEVEL;
        }

        @Override
        public Optional<BufferedImage> tile(int level, int x, int y) throws IOException {
            asked.countDown();
            try {
                released.await();
            } catch (InterruptedException e) {
                throw new IOException(e);
            }
            return Optional.of(BaseMapTest.tile(Color.GREEN));
        }

        @Override
        public void close() {
            closed.countDown();
        }
    }

    private final BlockingQueue<String> repaints = new LinkedBlockingQueue<>();

    private OfflineTiles tiles(TileSource source) {
        return new OfflineTiles(Optional.of(source), () -> repaints.add("repaint"), () -> {}, repaints::add);
    }

    /** The colour of a tile's middle once it has been read. */
    private Color paintedAfterReading(OfflineTiles tiles, int zoom, int x, int y) throws Exception {
        BufferedImage image = paint(tiles, zoom, x, y);
        while (colour(image).equals(Color.BLACK)) {
            assertThat(repaints.poll(60, TimeUnit.SECONDS)).isEqualTo("repaint");
            image = paint(tiles, zoom, x, y);
        }
        return colour(image);
    }

    private static BufferedImage paint(OfflineTiles tiles, int zoom, int x, int y) {
        BufferedImage image = new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        tiles.paint(g, zoom, new Rectangle(x * 256, y * 256, 255, 255));
        g.dispose();
        return image;
    }

    private static Color colour(BufferedImage image) {
        return new Color(image.getRGB(200, 100));
    }

    private static BufferedImage tile(Color color) {
        BufferedImage image = new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(color);
        g.fillRect(0, 0, 256, 256);
        g.dispose();
        return image;
    }

    /** A file with one orange tile. */
    private Path mbtiles(String name, String format) throws SQLException, IOException {
        Path file = folder.resolve(name);
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(tile(Color.ORANGE), "png", png);
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE TABLE metadata (name TEXT, value TEXT)");
            statement.execute("INSERT INTO metadata VALUES ('name', 'Lake'), ('bounds', '10.6,45.6,10.8,45.8'),"
                    + " ('attribution', 'made by <b>hand</b>'), ('format', '" + format + "')");
            statement.execute(
                    "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB)");
            try (PreparedStatement insert = connection.prepareStatement("INSERT INTO tiles VALUES (?, ?, ?, ?)")) {
                insert.setInt(1, LEVEL);
                insert.setInt(2, X);
                insert.setInt(3, (1 << LEVEL) - 1 - Y);
                insert.setBytes(4, png.toByteArray());
                insert.execute();
            }
        }
        return file;
    }
}
