package org.sami.ui.map.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;
import org.sami.ui.map.HeavyFiles;

/** Files of outlines: what is read, in which words others are refused, and what is painted. */
class OutlineSourceTest {
    private static final BaseStyle STYLE = new BaseStyle(Color.GREEN, Color.BLACK, 1);
    private static final double LAT = 45.7;
    private static final double LON = 10.72;

    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("shore.geojson"), text);
    }

    private static OutlineSource read(Path file) throws IOException {
        return OutlineSource.read(file, MapFileLimits.OF_A_FILE);
    }

    @Test
    void readsFeaturesGeometriesAndNamesInAnyOrder() throws Exception {
        OutlineSource shore = read(file("""
                {"features": [
                  {"geometry": {"coordinates": [10.72, 45.7], "type": "Point"}, "properties": {"depth": {"m": [3]}, "name": "pier"}, "type": "Feature"},
                  {"type": "Feature", "properties": {"name": "buoy"}, "geometry": {"type": "Point", "coordinates": [10.73, 45.7, 2.5]}},
                  {"type": "Feature", "properties": {}, "geometry": null},
                  {"type": "Feature", "properties": null, "geometry": {"type": "GeometryCollection", "geometries": [
                    {"type": "MultiLineString", "coordinates": [[[10, 45], [11, 45]], [[10, 46], [11, 46, 3]]]},
                    {"type": "MultiPolygon", "coordinates": [[[[10, 45], [11, 45], [11, 46], [10, 45]]]]},
                    {"type": "Polygon", "coordinates": [[[10, 45], [11, 45], [11, 46], [10, 45]]]}]}}],
                 "type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}}
                """));

        GeoBounds box = shore.bounds().orElseThrow();
        assertThat(box.southDeg()).isCloseTo(45, org.assertj.core.data.Offset.offset(1e-6));
        assertThat(box.eastDeg()).isCloseTo(11, org.assertj.core.data.Offset.offset(1e-6));
        assertThat(shore.restriction()).isEmpty();
        MapFrame frame = new MapFrame(Mercator.x(LON), Mercator.y(LAT), 256 * 1024, 800, 600);
        assertThat(shore.names(frame, 10)).extracting(NamedPoint::name).containsExactlyInAnyOrder("pier", "buoy");
        assertThat(shore.names(frame, 1))
                .as("more names than there is room for")
                .isEmpty();
    }

    static Stream<Arguments> wrongFiles() {
        String line = "{\"type\": \"LineString\", \"coordinates\": ";
        return Stream.of(
                arguments("cut off", line + "[[10, 45], [11", "line 1, column"),
                arguments(
                        "cut off in a feature",
                        "{\"type\": \"FeatureCollection\",\n\"features\": [{\"type\"",
                        "line 2"),
                arguments("no JSON", "shore of the lake", "is no JSON, line 1, column"),
                arguments("empty", "", "does not begin with an object"),
                arguments("a list", "[1, 2]", "does not begin with an object"),
                arguments("another document", "{\"name\": \"plan\"}", "'' is no type of it"),
                arguments(
                        "another type", "{\"type\": \"Circle\", \"coordinates\": [1, 2]}", "'Circle' is no type of it"),
                arguments("one position", line + "[[10, 45]]}", "a line has two positions or more, and one has 1"),
                arguments("half a position", line + "[[10], [11]]}", "a position is [longitude, latitude]"),
                arguments("words", line + "[[\"10\", \"45\"]]}", "a position is [longitude, latitude], not a text"),
                arguments("no list", line + "\"here\"}", "coordinates are a list, not a text"),
                arguments("objects", line + "[{\"lon\": 10}]}", "not an object"),
                arguments("metres", line + "[[634123.5, 5061234.2], [634124, 5061235]]}", "degrees are expected"),
                arguments("huge numbers", line + "[[1e999, 45], [10, 45]]}", "is not on the globe"),
                arguments("endless numbers", line + "[[" + "1".repeat(5000) + ", 45]]}", "line 1, column"),
                arguments("too deep", line + "[".repeat(5000), "nested too deep"),
                arguments("deep elsewhere", "{\"a\": " + "[".repeat(100_000), "line 1, column"),
                arguments("depths mixed", line + "[[10, 45], [[11, 45]]]}", "equally deep"),
                arguments("wrong depth", line + "[[[10, 45], [11, 45]]]}", "lie in 2 lists, not in 3"),
                arguments(
                        "no geometry",
                        "{\"type\": \"FeatureCollection\", \"features\": []}",
                        "nothing of it can be shown"),
                arguments("empty geometry", line + "[]}", "nothing of it can be shown"),
                arguments("something behind", line + "[[10, 45], [11, 45]]} {}", "something follows"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("wrongFiles")
    void aWrongFileIsRefusedWithItsNameThePlaceAndTheReason(String what, String text, String reason) throws Exception {
        Path wrong = file(text);

        assertThatIOException()
                .as(what)
                .isThrownBy(() -> read(wrong))
                .withMessageContaining(wrong.toString())
                .withMessageContaining(reason)
                .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(500).doesNotContain("\n"));
    }

    @Test
    void aFileThatIsNotUtf8IsRefusedWithThePlace() throws Exception {
        Path wrong = folder.resolve("shore.geojson");
        Files.write(
                wrong,
                "{\"type\": \"Feature\", \"properties\": {\"name\": \"Hafenstra\u00dfe\"}}"
                        .getBytes(StandardCharsets.ISO_8859_1));

        assertThatIOException()
                .isThrownBy(() -> read(wrong))
                .withMessageContaining(wrong.toString())
                .withMessageContaining("UTF-8")
                .withMessageContaining("line 1, column");
    }

    @Test
    void emptyGeometriesAmongOthersArePassedOver() throws Exception {
        OutlineSource shore = read(
                file(
                        "{\"type\": \"GeometryCollection\", \"geometries\": ["
                                + "{\"type\": \"LineString\", \"coordinates\": []}, {\"type\": \"Polygon\", \"coordinates\": [[]]},"
                                + "{\"type\": \"Point\", \"coordinates\": []}, {\"type\": \"LineString\", \"coordinates\": [[10, 45], [11, 46]]}]}"));

        assertThat(shore.bounds()).isPresent();
        assertThat(shore.restriction()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void whatIsBeyondTheBudgetIsNotShownAndItIsSaid(boolean ofOneLine) throws Exception {
        MapFileLimits small = new MapFileLimits(5_000, 100, 10, 60, System::nanoTime);
        Path large = ofOneLine
                ? HeavyFiles.line(folder.resolve("large.geojson"), 20_000)
                : HeavyFiles.outlines(folder.resolve("large.geojson"), 300);

        OutlineSource shown = OutlineSource.read(large, small);

        assertThat(shown.bounds()).isPresent();
        assertThat(shown.restriction().orElseThrow())
                .contains(large.toString())
                .contains(ofOneLine ? "more than 5,000 points" : "more than 100 lines and outlines");
    }

    @Test
    void singlePointsBeyondTheBudgetAreCounted() throws Exception {
        StringBuilder text = new StringBuilder("{\"type\": \"MultiPoint\", \"coordinates\": [[10, 45]");
        for (int i = 1; i < 2500; i++) {
            text.append(String.format(Locale.ROOT, ",[%.4f,45]", 10 + i / 5000.0));
        }
        Path many = file(text.append("]}").toString());

        assertThat(read(many).restriction()).contains(many + " has 2,500 single points: shown are the first 2,000");
    }

    @Test
    void readingEndsWhenItsTimeIsUp() throws Exception {
        AtomicLong clock = new AtomicLong();
        MapFileLimits short1 = new MapFileLimits(100_000, 100, 10, 1, () -> clock.getAndAdd(400_000_000));
        Path long1 = HeavyFiles.line(folder.resolve("long.geojson"), 20_000);

        Optional<String> said = OutlineSource.read(long1, short1).restriction();

        assertThat(said.orElseThrow()).contains(long1.toString()).contains("more than can be read within 1 s");
    }

    @Test
    void nameAndFileAreCutToFewLetters() throws Exception {
        Path file = file("{\"type\": \"Feature\", \"properties\": {\"name\": \"" + "pier \\u0007\\n".repeat(50_000)
                + "\"}, \"geometry\": {\"type\": \"Point\", \"coordinates\": [10.72, 45.7]}}");

        MapFrame frame = new MapFrame(Mercator.x(LON), Mercator.y(LAT), 256 * 1024, 800, 600);
        String name = read(file).names(frame, 10).get(0).name();

        assertThat(name).startsWith("pier pier").endsWith("…").hasSizeLessThanOrEqualTo(60);
    }

    /** A ring of 20,000 points with a hole: what is inside is land at every scale, also where nearly all of the ring is out of sight. */
    @ParameterizedTest
    @ValueSource(ints = {8, 11, 14, 17, 20, 22})
    void landIsFilledAtEveryScale(int level) throws Exception {
        String ring = ring(0.05, 20_000);
        String hole = ring(0.01, 3_000);
        OutlineSource land = read(file("{\"type\": \"Polygon\", \"coordinates\": [" + ring + "," + hole + "]}"));

        for (double east : new double[] {0, 0.009, 0.0099, 0.0101, 0.011, 0.03, 0.0499, 0.0501, 0.06}) {
            boolean isLand = east > 0.01 && east < 0.05;
            double away = Math.min(Math.abs(east - 0.01), Math.abs(east - 0.05));
            double px = Math.scalb(256.0, level);
            if (away / 360 * px > 3) { // next to the line
                assertThat(colour(land, px, GeoPoint.of(LAT, LON + east)))
                        .as("%.4f° from the middle", east)
                        .isEqualTo(isLand ? Color.GREEN.getRGB() : 0);
            }
        }
    }

    @Test
    void aLineAcrossTheWorldIsSeenAtTheNearestScale() throws Exception {
        OutlineSource line = read(file("{\"type\": \"LineString\", \"coordinates\": [[-170, 0], [170, 0]]}"));

        assertThat(colour(line, Math.scalb(256.0, 22), GeoPoint.of(0, 10.5))).isNotZero();
    }

    @Test
    void outlinesTooSmallForAScaleAreSeenAsDots() throws Exception {
        OutlineSource rocks = read(HeavyFiles.outlines(folder.resolve("rocks.geojson"), 2_000));

        BufferedImage tile = tile(rocks, Math.scalb(256.0, 9), GeoPoint.of(LAT, LON));

        assertThat(tile).isNotNull();
    }

    private static String ring(double radiusDeg, int points) {
        StringBuilder ring = new StringBuilder("[");
        for (int i = 0; i <= points; i++) {
            double angle = 2 * Math.PI * (i % points) / points;
            ring.append(i == 0 ? "" : ",")
                    .append(String.format(
                            Locale.ROOT,
                            "[%.8f,%.8f]",
                            LON + radiusDeg * Math.cos(angle),
                            LAT + radiusDeg * Math.sin(angle)));
        }
        return ring.append("]").toString();
    }

    private static int colour(BaseSource source, double worldPx, GeoPoint at) throws IOException {
        double x = Mercator.x(at.lonDeg()) * worldPx;
        double y = Mercator.y(at.latDeg()) * worldPx;
        BufferedImage tile = tile(source, worldPx, at);
        return tile == null ? 0 : tile.getRGB(Math.floorMod((int) x, TileKey.PX), Math.floorMod((int) y, TileKey.PX));
    }

    private static BufferedImage tile(BaseSource source, double worldPx, GeoPoint at) throws IOException {
        double x = Mercator.x(at.lonDeg()) * worldPx;
        double y = Mercator.y(at.latDeg()) * worldPx;
        return source.tile(new TileKey(worldPx, (int) x / TileKey.PX, (int) y / TileKey.PX), STYLE)
                .orElse(null);
    }
}
