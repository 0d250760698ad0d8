package org.sami.ui.map;

import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;

/** Real map files that are never read to their end. */
public final class SlowFiles {
    private SlowFiles() {}

    /**
     * A pipe to which nobody writes: who opens it waits.
     *
     * @throws IOException if this system makes no pipes
     */
    public static Path pipe(Path file) throws IOException {
        try {
            if (new ProcessBuilder("mkfifo", file.toString()).start().waitFor() != 0) {
                throw new IOException("mkfifo makes no pipe " + file);
            }
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        return file;
    }

    /** An MBTiles file whose tiles are a view without an end: who asks for the finest level waits. */
    public static Path endlessTiles(Path file) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE TABLE metadata (name TEXT, value TEXT)");
            statement.execute("CREATE VIEW tiles AS"
                    + " WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT (i + 1) % 20 FROM n)"
                    + " SELECT i AS zoom_level, 0 AS tile_column, 0 AS tile_row, x'' AS tile_data FROM n");
        }
        return file;
    }
}
