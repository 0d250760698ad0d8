package org.sami.session.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tiles as browsers ask for them. */
class TileFileTest {
    @TempDir
    private Path folder;

    @Test
    void rowsAreCountedFromTheNorth() throws Exception {
        Path file = TestTiles.write(folder.resolve("lake.mbtiles"), "png", 3, 5, 1);

        try (TileFile tiles = TileFile.open(file)) {
            assertThat(tiles.tile(3, 5, 1)).contains(TestTiles.PICTURE);
            assertThat(tiles.tile(3, 5, 6)).isEmpty();
            assertThat(tiles.tile(40, 0, 0)).isEmpty();
            assertThat(tiles.description()).isEqualTo(new TileFile.Description("made by hand", 3, 3, "image/png"));
        }
    }

    @Test
    void whatIsNoMapIsNamed() throws Exception {
        Path notes = Files.writeString(folder.resolve("notes.mbtiles"), "these are notes, and no database at all");
        Path vector = TestTiles.write(folder.resolve("vector.mbtiles"), "pbf", 3, 5, 1);
        Path gone = folder.resolve("gone.mbtiles");

        assertThatIOException().isThrownBy(() -> TileFile.open(notes)).withMessageContaining(notes + " is no map");
        assertThatIOException().isThrownBy(() -> TileFile.open(vector)).withMessageContaining("the format 'pbf'");
        assertThatIOException().isThrownBy(() -> TileFile.open(gone)).withMessage("there is no map file " + gone);
    }
}
