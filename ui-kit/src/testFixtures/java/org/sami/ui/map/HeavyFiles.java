package org.sami.ui.map;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Locale;
import java.util.Random;

/** Map files that are large, dense or wrong, made on the spot; the same each time. */
public final class HeavyFiles {
    private static final double LAT = 45.7;
    private static final double LON = 10.72;

    private HeavyFiles() {}

    /** A GeoJSON file with one line of so many points, about a metre apart, that wanders around the lake. */
    public static Path line(Path file, int points) throws IOException {
        Random random = new Random(3);
        double lat = LAT;
        double lon = LON;
        double heading = 0;
        try (BufferedWriter out = Files.newBufferedWriter(file)) {
            out.write("{\"type\": \"LineString\", \"coordinates\": [");
            for (int i = 0; i < points; i++) {
                heading += random.nextGaussian() * 0.3;
                lat += 1e-5 * Math.cos(heading) - (lat - LAT) * 1e-4;
                lon += 1e-5 * Math.sin(heading) - (lon - LON) * 1e-4;
                out.write((i == 0 ? "[" : ",[") + lon + "," + lat + "]");
            }
            out.write("]}");
        }
        return file;
    }

    /** A GeoJSON file with so many small outlines of 12 corners each, all over the lake. */
    public static Path outlines(Path file, int outlines) throws IOException {
        Random random = new Random(5);
        try (BufferedWriter out = Files.newBufferedWriter(file)) {
            out.write("{\"type\": \"FeatureCollection\", \"features\": [");
            for (int i = 0; i < outlines; i++) {
                double lat = LAT + random.nextDouble() * 0.1 - 0.05;
                double lon = LON + random.nextDouble() * 0.1 - 0.05;
                out.write(i == 0 ? "" : ",");
                out.write(
                        "{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[");
                for (int k = 0; k <= 12; k++) {
                    double angle = k % 12 * Math.PI / 6;
                    out.write(String.format(
                            Locale.ROOT,
                            "%s[%.7f,%.7f]",
                            k == 0 ? "" : ",",
                            lon + 2e-4 * Math.cos(angle),
                            lat + 1.5e-4 * Math.sin(angle)));
                }
                out.write("]]}}\n");
            }
            out.write("]}");
        }
        return file;
    }

    /** A GeoJSON file of so many bytes whose line has one position, of many parts. */
    public static Path wrongLine(Path file, int bytes) throws IOException {
        try (BufferedWriter out = Files.newBufferedWriter(file)) {
            out.write("{\"type\": \"LineString\", \"coordinates\": [[null");
            String wrong = ",\"10.72 45.7\"";
            for (int i = 0; i < bytes / wrong.length(); i++) {
                out.write(wrong);
            }
            out.write("]]}");
        }
        return file;
    }

    /** An MBTiles file with one tile, the picture given, and whom to name for it. */
    public static Path tiles(Path file, int level, int x, int y, byte[] picture, String attribution)
            throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE TABLE metadata (name TEXT, value TEXT)");
            statement.execute("INSERT INTO metadata VALUES ('name', 'Lake'), ('bounds', '10.6,45.6,10.8,45.8'),"
                    + " ('format', 'png')");
            try (PreparedStatement insert =
                    connection.prepareStatement("INSERT INTO metadata VALUES ('attribution', ?)")) {
                insert.setString(1, attribution);
                insert.execute();
            }
            statement.execute(
                    "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB)");
            try (PreparedStatement insert = connection.prepareStatement("INSERT INTO tiles VALUES (?, ?, ?, ?)")) {
                insert.setInt(1, level);
                insert.setInt(2, x);
                insert.setInt(3, (1 << level) - 1 - y);
                insert.setBytes(4, picture);
                insert.execute();
            }
        }
        return file;
    }
}
