package org.sami.ui.map.base;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.sami.spn.sqlite.SqliteLibrary;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sqlite.ProgressHandler;
import org.sqlite.SQLiteConfig;

/**
 * Raster tiles in one SQLite file (MBTiles 1.3). Its rows are counted from the south. Reading ends when its thread is interrupted: a
 * table of tiles may be a view that takes forever.
 */
public final class MbTiles implements BaseSource {
    private static final int MOST_LEVEL = 22;
    private static final int CHECK_INTERVAL = 10_000; // instructions of SQLite, less than a millisecond
    private static final int READ_LETTERS = 2000; // of an entry of the metadata

    private final Path file;
    private final Connection connection;
    private final PreparedStatement query;
    private final String name;
    private final String attribution;
    private final Optional<GeoBounds> bounds;
    private final Optional<String> restriction;
    private final int coarsestLevel;
    private final int finestLevel;

    /** A text of the file's metadata: its beginning, and how many letters it has. */
    private record Metadata(String start, long letters) {
        String whole() {
            return letters > READ_LETTERS ? start + "…" : start;
        }
    }

    private MbTiles(Path file, Connection connection) throws SQLException, IOException {
        this.file = file;
        this.connection = connection;
        String format = metadata("format").start().toLowerCase(Locale.ROOT);
        if (format.equals("pbf") || format.equals("mvt")) {
            throw new IOException(file + " holds vector tiles (" + format
                    + "), which cannot be shown: take an export with png or jpg tiles");
        }
        Metadata named = metadata("name");
        name = named.start().isBlank()
                ? MapFileLimits.cut(file.getFileName().toString(), MapFileLimits.NAME_LETTERS)
                : MapFileLimits.cut(named.whole(), MapFileLimits.NAME_LETTERS);
        Metadata thanks = metadata("attribution");
        attribution = MapFileLimits.cut(
                thanks.whole().replaceAll("<[^>]*>", ""), MapFileLimits.ATTRIBUTION_LETTERS); // it may be HTML
        restriction = thanks.letters() <= READ_LETTERS
                ? Optional.empty()
                : Optional.of(file + " has an attribution of " + MapFileLimits.number(thanks.letters())
                        + " letters: its beginning is shown");
        bounds = bounds(metadata("bounds").start());
        try (Statement statement = connection.createStatement();
                ResultSet levels = statement.executeQuery("SELECT min(zoom_level), max(zoom_level) FROM tiles")) {
            coarsestLevel = Math.max(0, levels.next() ? levels.getInt(1) : 0);
            finestLevel = Math.min(MOST_LEVEL, levels.getInt(2));
            if (levels.wasNull() || finestLevel < coarsestLevel) {
                throw new IOException(file + " holds no tile: export the map again");
            }
        }
        query = connection.prepareStatement("SELECT length(tile_data), tile_data FROM tiles"
                + " WHERE zoom_level = ? AND tile_column = ? AND tile_row = ?");
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
        SqliteLibrary.choose();
        SQLiteConfig config = new SQLiteConfig();
        config.setReadOnly(true);
        Connection connection = null;
        try {
            connection = config.createConnection("jdbc:sqlite:" + file);
            ProgressHandler.setHandler(connection, CHECK_INTERVAL, new ProgressHandler() {
                @Override
                protected int progress() {
                    return Thread.currentThread().isInterrupted() ? 1 : 0; // 1 ends the statement
                }
            });
            return new MbTiles(file, connection);
        } catch (SQLException e) {
            close(connection);
            throw new IOException(
                    file + " is no map of MBTiles: " + MapFileLimits.cut(String.valueOf(e.getMessage()), 200), e);
        } catch (IOException e) {
            close(connection);
            throw e;
        }
    }

    private static void close(@Nullable Connection connection) {
        try {
            if (connection != null) {
                connection.close();
            }
        } catch (SQLException e) {
            // the fault of the file is reported already
        }
    }

    /** The beginning of an entry; a file may have one of any length. */
    private Metadata metadata(String entry) throws SQLException {
        try (PreparedStatement statement = connection.prepareStatement("SELECT substr(CAST(value AS TEXT), 1, "
                + READ_LETTERS + "), length(CAST(value AS TEXT)) FROM metadata WHERE name = ? LIMIT 1")) {
            statement.setString(1, entry);
            try (ResultSet row = statement.executeQuery()) {
                String start = row.next() ? row.getString(1) : null;
                return start == null ? new Metadata("", 0) : new Metadata(start, row.getLong(2));
            }
        }
    }

    private static Optional<GeoBounds> bounds(String text) {
        try {
            double[] numbers = Arrays.stream(text.split(",", -1))
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
    public String name() {
        return name;
    }

    @Override
    public String attribution() {
        return attribution;
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return bounds;
    }

    @Override
    public boolean isImagery() {
        return true;
    }

    @Override
    public Optional<String> restriction() {
        return restriction;
    }

    @Override
    public double tileScale(double worldPx) {
        long level = Math.round(Math.log(worldPx / TileKey.PX) / Math.log(2));
        return worldPx((int) Math.max(0, Math.min(finestLevel, level)));
    }

    private static double worldPx(int level) {
        return Math.scalb((double) TileKey.PX, level);
    }

    private static int level(double worldPx) {
        return Math.getExponent(worldPx / TileKey.PX);
    }

    @Override
    public OptionalDouble coarser(double tileScale) {
        int level = level(tileScale);
        return level > coarsestLevel ? OptionalDouble.of(worldPx(level - 1)) : OptionalDouble.empty();
    }

    @Override
    public synchronized Optional<BufferedImage> tile(TileKey key, BaseStyle style) throws IOException {
        int level = level(key.worldPx());
        try {
            query.setInt(1, level);
            query.setInt(2, key.x());
            query.setInt(3, (1 << level) - 1 - key.y());
            try (ResultSet rows = query.executeQuery()) {
                if (!rows.next()) {
                    return Optional.empty();
                }
                String which = file + ": tile " + key.x() + ", " + key.y() + " of level " + level;
                if (rows.getLong(1) > MapFileLimits.TILE_BYTES) {
                    throw new IOException(which + " has " + MapFileLimits.number(rows.getLong(1)) + " bytes, more than "
                            + MapFileLimits.number(MapFileLimits.TILE_BYTES) + ", and is left out");
                }
                byte[] picture = rows.getBytes(2);
                return Optional.of(TilePicture.read(picture == null ? new byte[0] : picture, which));
            }
        } catch (SQLException e) {
            throw new IOException(
                    file + " cannot be read: " + MapFileLimits.cut(String.valueOf(e.getMessage()), 200), e);
        }
    }

    @Override
    public List<NamedPoint> names(MapFrame frame, int most) {
        return List.of();
    }

    @Override
    public synchronized void close() throws IOException {
        try {
            connection.close();
        } catch (SQLException e) {
            throw new IOException(file + " cannot be closed: " + e.getMessage(), e);
        }
    }
}
