package org.sami.ui.map.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.Statement;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.map.HeavyFiles;

/** Files of tiles: what is read of them, and in which words others are refused. */
@Tag("long")
class MbTilesTest {
    private static final int LEVEL = 14;
    private static final int X = 8680;
    private static final int Y = 5835;
    private static final TileKey KEY = new TileKey(Math.scalb(256.0, LEVEL), X, Y);
    private static final BaseStyle STYLE = new BaseStyle(Color.GREEN, Color.BLACK, 1);

    @TempDir
    private Path folder;

    private Path tiles(byte[] picture, String attribution) throws Exception {
        return HeavyFiles.tiles(folder.resolve("lake.mbtiles"), LEVEL, X, Y, picture, attribution);
    }

    private static byte[] png(int width, int height) throws IOException {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_BINARY);
        Graphics2D g = image.createGraphics();
        g.setColor(Color.WHITE);
        g.fillRect(0, 0, width, height);
        g.dispose();
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return png.toByteArray();
    }

    @Test
    void readsTilesWhoseRowsAreCountedFromTheSouth() throws Exception {
        try (MbTiles tiles = MbTiles.open(tiles(png(256, 256), "made by <b>hand</b>"))) {
            assertThat(tiles.name()).isEqualTo("Lake");
            assertThat(tiles.attribution()).isEqualTo("made by hand");
            assertThat(tiles.tileScale(1e12)).isEqualTo(KEY.worldPx());
            assertThat(tiles.bounds()).contains(new GeoBounds(45.6, 10.6, 45.8, 10.8));
            assertThat(tiles.tile(KEY, STYLE).orElseThrow().getRGB(100, 100)).isEqualTo(Color.WHITE.getRGB());
            assertThat(tiles.tile(new TileKey(KEY.worldPx(), X, Y + 1), STYLE)).isEmpty();
        }
    }

    @Test
    void namesAFileThatIsNoMap() throws Exception {
        Path text = Files.writeString(folder.resolve("notes.mbtiles"), "these are notes, and no database at all");
        Path gone = folder.resolve("gone.mbtiles");
        Path vector = tiles(png(256, 256), "");
        sql(vector, "UPDATE metadata SET value = 'pbf' WHERE name = 'format'");

        assertThatIOException().isThrownBy(() -> MbTiles.open(text)).withMessageContaining(text.toString());
        assertThatIOException().isThrownBy(() -> MbTiles.open(gone)).withMessage("There is no map file " + gone);
        assertThatIOException().isThrownBy(() -> MbTiles.open(vector)).withMessageContaining("vector tiles");
    }

    @ParameterizedTest
    @ValueSource(strings = {"DELETE FROM tiles", "DROP TABLE tiles", "DROP TABLE metadata"})
    void namesAFileWhoseTablesAreNotThere(String damage) throws Exception {
        Path damaged = tiles(png(256, 256), "");
        sql(damaged, damage);

        assertThatIOException().isThrownBy(() -> MbTiles.open(damaged)).withMessageContaining(damaged.toString());
    }

    @Test
    void aPictureOfManyPixelsIsLeftOutBeforeItTakesMemory() throws Exception {
        byte[] bomb = png(30_000, 30_000);
        assertThat(bomb).as("it is small in its file").hasSizeLessThan(1_000_000);
        Path file = tiles(bomb, "");

        try (MbTiles tiles = MbTiles.open(file)) {
            assertThatIOException()
                    .isThrownBy(() -> tiles.tile(KEY, STYLE))
                    .withMessageContaining(file + ": tile 8680, 5835 of level 14 has 30000 by 30000 pixels");
        }
    }

    @Test
    void aTileOfManyBytesIsLeftOut() throws Exception {
        Path file = tiles(new byte[20_000_000], "");

        try (MbTiles tiles = MbTiles.open(file)) {
            assertThatIOException()
                    .isThrownBy(() -> tiles.tile(KEY, STYLE))
                    .withMessageContaining(file.toString())
                    .withMessageContaining("20,000,000 bytes");
        }
    }

    @Test
    void aBrokenPictureIsNamed() throws Exception {
        byte[] cut = java.util.Arrays.copyOf(png(256, 256), 60);
        Path file = tiles(cut, "");

        try (MbTiles tiles = MbTiles.open(file)) {
            assertThatIOException()
                    .isThrownBy(() -> tiles.tile(KEY, STYLE))
                    .withMessageContaining(file + ": tile 8680, 5835 of level 14");
        }
    }

    @Test
    void aLargerTileKeepsItsDetailUpToTwiceTheSize() throws Exception {
        try (MbTiles tiles = MbTiles.open(tiles(png(1024, 1024), ""))) {
            assertThat(tiles.tile(KEY, STYLE).orElseThrow().getWidth()).isEqualTo(512);
        }
    }

    @Test
    void aLongAttributionIsCutAndItIsSaid() throws Exception {
        Path file = tiles(png(256, 256), "<i>somebody</i> and others ".repeat(1000));

        try (MbTiles tiles = MbTiles.open(file)) {
            assertThat(tiles.attribution())
                    .startsWith("somebody and")
                    .endsWith("…")
                    .hasSizeLessThanOrEqualTo(160);
            assertThat(tiles.restriction())
                    .contains(file + " has an attribution of 27,000 letters: its beginning is shown");
        }
    }

    private static void sql(Path file, String text) throws Exception {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute(text);
        }
    }
}
