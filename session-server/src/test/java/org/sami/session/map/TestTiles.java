package org.sami.session.map;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Base64;

/** A map of one tile. */
public final class TestTiles {
    /** A picture of one grey point. */
    public static final byte[] PICTURE = Base64.getDecoder()
            .decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==");

    private TestTiles() {}

    /** Writes it; y is counted from the north. */
    public static Path write(Path file, String format, int level, int x, int y) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE TABLE metadata (name TEXT, value TEXT)");
            statement.execute(
                    "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB)");
            statement.execute("INSERT INTO metadata VALUES ('format', '" + format + "'),"
                    + " ('attribution', 'made by <b>hand</b>')");
            try (PreparedStatement tile = connection.prepareStatement("INSERT INTO tiles VALUES (?, ?, ?, ?)")) {
                tile.setInt(1, level);
                tile.setInt(2, x);
                tile.setInt(3, (1 << level) - 1 - y);
                tile.setBytes(4, PICTURE);
                tile.execute();
            }
        }
        return file;
    }
}
