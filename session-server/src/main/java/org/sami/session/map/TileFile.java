package org.sami.session.map;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Locale;
import java.util.Optional;
import org.sami.spn.sqlite.SqliteLibrary;
import org.sqlite.SQLiteConfig;

/** The raster tiles of one SQLite file (MBTiles 1.3), read as they stand in it. Safe for use by several threads, which wait for each other. */
public final class TileFile implements AutoCloseable {
    private static final int MOST_LEVEL = 22;
    private static final int MOST_TILE_BYTES = 4 << 20;
    private static final int MOST_ATTRIBUTION_LETTERS = 200;

    private final Path file;
    private final Connection connection;
    private final Description description;

    /**
     * What a map is made of.
     *
     * @param attribution whom it is owed to, without marks of HTML; may be empty
     * @param coarsest the least level of zoom that has tiles
     * @param finest the greatest
     * @param mediaType of its tiles
     */
    public record Description(String attribution, int coarsest, int finest, String mediaType) {}

    private TileFile(Path file, Connection connection) throws SQLException, IOException {
        this.file = file;
        this.connection = connection;
        String format = metadata("format").toLowerCase(Locale.ROOT);
        String mediaType = switch (format) {
            case "jpg", "jpeg" -> "image/jpeg";
            case "webp" -> "image/webp";
            case "png", "" -> "image/png";
            default ->
                throw new IOException(file + " holds tiles in the format '" + format
                        + "', which the page cannot show: take an export with png or jpg tiles");
        };
        String attribution = metadata("attribution").replaceAll("<[^>]*>", "");
        try (Statement statement = connection.createStatement();
                ResultSet levels = statement.executeQuery("SELECT min(zoom_level), max(zoom_level) FROM tiles")) {
            int coarsest = Math.max(0, levels.next() ? levels.getInt(1) : 0);
            int finest = Math.min(MOST_LEVEL, levels.getInt(2));
            if (levels.wasNull() || finest < coarsest) {
                throw new IOException(file + " holds no tile: export the map again");
            }
            description = new Description(
                    attribution.substring(0, Math.min(MOST_ATTRIBUTION_LETTERS, attribution.length())),
                    coarsest,
                    finest,
                    mediaType);
        }
    }

    /**
     * Opens a file for reading.
     *
     * @throws IOException with the file's name and what is wrong, if it is no MBTiles file with raster tiles
     */
    public static TileFile open(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new IOException("there is no map file " + file);
        }
        SqliteLibrary.choose();
        SQLiteConfig config = new SQLiteConfig();
        config.setReadOnly(true);
        try {
            Connection connection = config.createConnection("jdbc:sqlite:" + file);
            try {
                return new TileFile(file, connection);
            } catch (SQLException | IOException unfit) {
                connection.close();
                throw unfit;
            }
        } catch (SQLException unfit) {
            throw new IOException(file + " is no map of MBTiles: " + unfit.getMessage(), unfit);
        }
    }

    private String metadata(String entry) throws SQLException {
        try (PreparedStatement statement = connection.prepareStatement(
                "SELECT substr(CAST(value AS TEXT), 1, 2000) FROM metadata WHERE name = ? LIMIT 1")) {
            statement.setString(1, entry);
            try (ResultSet row = statement.executeQuery()) {
                String text = row.next() ? row.getString(1) : null;
                return text == null ? "" : text;
            }
        }
    }

    public Description description() {
        return description;
    }

    /**
     * A tile.
     *
     * @param level of zoom
     * @param x column from the west
     * @param y row from the north, as browsers count them; the file counts from the south
     * @return empty where the file has none, or none that is small enough
     * @throws IOException if the file cannot be read
     */
    public synchronized Optional<byte[]> tile(int level, int x, int y) throws IOException {
        if (level < 0 || level > MOST_LEVEL) {
            return Optional.empty();
        }
        try (PreparedStatement query = connection.prepareStatement("SELECT tile_data FROM tiles"
                + " WHERE zoom_level = ? AND tile_column = ? AND tile_row = ? AND length(tile_data) <= ?")) {
            query.setInt(1, level);
            query.setInt(2, x);
            query.setInt(3, (1 << level) - 1 - y);
            query.setInt(4, MOST_TILE_BYTES);
            try (ResultSet rows = query.executeQuery()) {
                return rows.next() ? Optional.ofNullable(rows.getBytes(1)) : Optional.empty();
            }
        } catch (SQLException fault) {
            throw new IOException(file + " cannot be read: " + fault.getMessage(), fault);
        }
    }

    @Override
    public synchronized void close() throws IOException {
        try {
            connection.close();
        } catch (SQLException fault) {
            throw new IOException(file + " cannot be closed: " + fault.getMessage(), fault);
        }
    }
}
