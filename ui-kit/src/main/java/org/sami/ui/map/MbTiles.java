package org.sami.ui.map;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.sami.ui.geo.GeoBounds;
import org.sqlite.ProgressHandler;
import org.sqlite.SQLiteConfig;

/**
 * Raster tiles in one SQLite file (MBTiles 1.3). Its rows are counted from the south. Reading ends when its thread is interrupted: a
 * table of tiles may be a view that takes for ever.
 */
public final class MbTiles implements TileSource {
    private static final int MOST_LEVEL = 22;
    private static final int LOOK_EVERY = 10_000; // instructions of SQLite, less than a millisecond

    private final Path file;
    private final Connection connection;
    private final PreparedStatement query;
    private final Map<String, String> metadata;
    private final int finestLevel;

    private MbTiles(Path file, Connection connection) throws SQLException, IOException {
        this.file = file;
        this.connection = connection;
        metadata = metadata(connection);
        String format = metadata.getOrDefault("format", "png").toLowerCase(Locale.ROOT);
        if (format.equals("pbf") || format.equals("mvt")) {
            throw new IOException(file + " holds vector tiles (" + format
                    + "), which cannot be shown: take an export with png or jpg tiles");
        }
        try (Statement statement = connection.createStatement();
                ResultSet most = statement.executeQuery("SELECT max(zoom_level) FROM tiles")) {
            finestLevel = Math.min(MOST_LEVEL, most.next() ? most.getInt(1) : 0);
            if (most.wasNull()) {
                throw new IOException(file + " holds no tile: export the map again");
            }
        }
        query = connection.prepareStatement(
                "SELECT tile_data FROM tiles WHERE zoom_level = ? AND tile_column = ? AND tile_row = ?");
    }

    /**
     * Opens a file for reading; takes as long as the file does.
     *
     * @throws IOException with the file's name and what is wrong, if it is no MBTiles file with raster tiles
     */
    public static MbTiles open(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException("There is no map file " + file);
        }
        SQLiteConfig config = new SQLiteConfig();
        config.setReadOnly(true);
        Connection connection = null;
        try {
            connection = config.createConnection("jdbc:sqlite:" + file);
            ProgressHandler.setHandler(connection, LOOK_EVERY, new ProgressHandler() {
                @Override
                protected int progress() {
                    return Thread.currentThread().isInterrupted() ? 1 : 0; // 1 ends the statement
                }
            });
            return new MbTiles(file, connection);
        } catch (SQLException e) {
            close(connection);
            throw new IOException(file + " is no map of MBTiles: " + e.getMessage(), e);
        } catch (IOException e) {
            close(connection);
            throw e;
        }
    }

    private static void close(Connection connection) {
        try {
            if (connection != null) {
                connection.close();
            }
        } catch (SQLException e) {
            // what was wrong with the file is said already
        }
    }

    private static Map<String, String> metadata(Connection connection) throws SQLException {
        Map<String, String> metadata = new LinkedHashMap<>();
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery("SELECT name, value FROM metadata")) {
            while (rows.next()) {
                metadata.put(String.valueOf(rows.getString(1)), String.valueOf(rows.getString(2)));
            }
        }
        return metadata;
    }

    @Override
    public String name() {
        return metadata.getOrDefault("name", file.getFileName().toString());
    }

    @Override
    public String attribution() {
        return metadata.getOrDefault("attribution", "")
                .replaceAll("<[^>]*>", "")
                .strip();
    }

    @Override
    public Optional<GeoBounds> bounds() {
        try {
            double[] numbers = Arrays.stream(metadata.getOrDefault("bounds", "").split(",", -1))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            return numbers.length == 4
                    ? Optional.of(new GeoBounds(numbers[1], numbers[0], numbers[3], numbers[2]))
                    : Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.empty(); // a map without a box is shown all the same
        }
    }

    @Override
    public int finestLevel() {
        return finestLevel;
    }

    @Override
    public Optional<BufferedImage> tile(int level, int x, int y) throws IOException {
        try {
            query.setInt(1, level);
            query.setInt(2, x);
            query.setInt(3, (1 << level) - 1 - y);
            try (ResultSet rows = query.executeQuery()) {
                if (!rows.next()) {
                    return Optional.empty();
                }
                BufferedImage image = ImageIO.read(new ByteArrayInputStream(rows.getBytes(1)));
                if (image == null) {
                    throw new IOException(file + ": tile " + x + ", " + y + " of level " + level + " is no picture");
                }
                return Optional.of(image);
            }
        } catch (SQLException e) {
            throw new IOException(file + " cannot be read: " + e.getMessage(), e);
        }
    }

    @Override
    public void close() throws IOException {
        try {
            connection.close();
        } catch (SQLException e) {
            throw new IOException(file + " cannot be closed: " + e.getMessage(), e);
        }
    }
}
