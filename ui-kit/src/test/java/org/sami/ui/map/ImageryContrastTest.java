package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.palette.Contrast;
import org.sami.palette.IdentityMark;
import org.sami.palette.Theme;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.EventThread;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.look.Look;

/**
 * What is drawn on imagery is seen on it, be it dark or light, in every look: 3:1 as WCAG 2.1 asks of graphics, between a line and its casing or
 * between one of them and the imagery. The theme is the whole process's.
 */
@Isolated
class ImageryContrastTest {
    private static final int WITHIN_S = 60;
    private static final double SEEN = 3;

    @TempDir
    private Path folder;

    private MapView map;

    static Stream<Arguments> grounds() {
        List<Arguments> all = new ArrayList<>();
        for (Theme theme : Theme.values()) {
            for (int ground : new int[] {0x0A140E, 0x3C5038, 0x808080, 0xC2B48C, 0xF4F2EC}) {
                all.add(Arguments.of(theme, new Color(ground)));
            }
        }
        return all.stream();
    }

    @AfterEach
    void close() {
        onEventThread(() -> {
            map.close();
            Look.apply(Theme.LIGHT, 100);
            return map;
        });
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("grounds")
    void tracksOfAllBoatsAreSeenFromTheirFirstPointToTheirLast(Theme theme, Color ground) throws Exception {
        open(theme, ground);
        onEventThread(() -> {
            TrackLayer tracks = map.layers().add(new TrackLayer("tracks", "Tracks"));
            List<Track> all = new ArrayList<>();
            for (int boat = 0; boat < IdentityMark.COUNT; boat++) {
                all.add(new Track("boat" + boat, new IdentityMark(boat), eastwards(boat)));
            }
            tracks.show(all);
            return map;
        });
        untilImagerySeen(ground);
        BufferedImage image = paint();

        for (int boat = 0; boat < IdentityMark.COUNT; boat++) {
            for (int eastM : new int[] {-95, -55, -15, 25, 65, 95}) {
                int x = px(MapScenes.at(eastM, northM(boat)));
                int y = py(MapScenes.at(eastM, northM(boat)));
                assertThat(contrast(image, x, y - 5, 1, 11))
                        .as("track of boat %d, %d m east", boat, eastM)
                        .isGreaterThanOrEqualTo(SEEN);
            }
        }
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("grounds")
    void noGoAreasAndFencesAreSeen(Theme theme, Color ground) throws Exception {
        open(theme, ground);
        onEventThread(() -> {
            AreaLayer areas = map.layers().add(new AreaLayer("areas", "Areas"));
            areas.show(List.of(
                    new ShownArea("reeds", "", MapScenes.square(0, 0, 60), ShownArea.Kind.NO_GO),
                    new ShownArea("fence", "", MapScenes.square(0, 0, 90), ShownArea.Kind.FENCE)));
            return map;
        });
        untilImagerySeen(ground);
        BufferedImage image = paint();

        int left = px(MapScenes.at(-50, 0));
        int top = py(MapScenes.at(0, 50));
        int side = px(MapScenes.at(50, 0)) - left;
        for (int x = left; x < left + side - 14; x += 14) {
            for (int y = top; y < top + side - 14; y += 14) {
                assertThat(contrast(image, x, y, 14, 14))
                        .as("hatching at %d, %d", x, y)
                        .isGreaterThanOrEqualTo(SEEN);
            }
        }
        int free = 0;
        for (int x = left; x < left + side; x++) {
            for (int y = top; y < top + side; y++) {
                free += Contrast.of(new Color(image.getRGB(x, y)), ground) < 1.2 ? 1 : 0;
            }
        }
        assertThat(free).as("the imagery is seen between the lines").isGreaterThan(side * side / 3);
        for (int eastM = -80; eastM <= 80; eastM += 20) {
            GeoPoint at = MapScenes.at(eastM, 90);
            assertThat(contrast(image, px(at), py(at) - 5, 17, 11)) // a dash and a gap
                    .as("fence, %d m east", eastM)
                    .isGreaterThanOrEqualTo(SEEN);
        }
    }

    @ParameterizedTest(name = "{0} on {1}")
    @MethodSource("grounds")
    void pathsAreSeen(Theme theme, Color ground) throws Exception {
        open(theme, ground);
        onEventThread(() -> {
            PathLayer paths = map.layers().add(new PathLayer("paths", "Paths"));
            List<PlannedPath> all = new ArrayList<>();
            for (int boat = 0; boat < IdentityMark.COUNT; boat++) {
                all.add(new PlannedPath(
                        "p" + boat,
                        new IdentityMark(boat),
                        List.of(
                                MapScenes.at(-100, northM(boat)),
                                MapScenes.at(0, northM(boat)),
                                MapScenes.at(100, northM(boat))),
                        1));
            }
            paths.show(all);
            return map;
        });
        untilImagerySeen(ground);
        BufferedImage image = paint();

        for (int boat = 0; boat < IdentityMark.COUNT; boat++) {
            for (int eastM : new int[] {-60, 60}) {
                GeoPoint at = MapScenes.at(eastM, northM(boat));
                assertThat(contrast(image, px(at), py(at) - 5, 1, 11))
                        .as("path of boat %d, %d m east", boat, eastM)
                        .isGreaterThanOrEqualTo(SEEN);
            }
        }
    }

    private static double northM(int boat) {
        return 60 - 10.0 * boat;
    }

    private static List<GeoPoint> eastwards(int boat) {
        List<GeoPoint> points = new ArrayList<>();
        for (int east = -100; east <= 100; east += 5) {
            points.add(MapScenes.at(east, northM(boat)));
        }
        return points;
    }

    private void open(Theme theme, Color ground) throws Exception {
        BufferedImage picture = new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = picture.createGraphics();
        g.setColor(ground);
        g.fillRect(0, 0, 256, 256);
        g.dispose();
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(picture, "png", png);
        Path file = HeavyFiles.tiles(folder.resolve("ground.mbtiles"), 3, 4, 2, png.toByteArray(), "");
        map = onEventThread(() -> {
            Look.apply(theme, 100);
            MapView made = new MapView();
            MapScenes.size(made, 800, 600);
            made.fit(new GeoBounds(
                    MapScenes.at(0, -100).latDeg(),
                    MapScenes.at(-100, 0).lonDeg(),
                    MapScenes.at(0, 100).latDeg(),
                    MapScenes.at(100, 0).lonDeg()));
            made.openBaseMap(file);
            return made;
        });
    }

    private void untilImagerySeen(Color ground) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(WITHIN_S);
        while (paint().getRGB(30, 30) != ground.getRGB()) {
            assertThat(System.nanoTime()).as("imagery is seen").isLessThan(end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(5));
        }
    }

    private BufferedImage paint() {
        return onEventThread(() -> MapScenes.paint(map));
    }

    private int px(GeoPoint at) {
        return (int) Math.round(map.frame().px(at));
    }

    private int py(GeoPoint at) {
        return (int) Math.round(map.frame().py(at));
    }

    /** The most contrast of two pixels of a box: of a line with its casing, or of one of them with the imagery. */
    private static double contrast(BufferedImage image, int left, int top, int width, int height) {
        List<Color> colours = new ArrayList<>();
        for (int x = left; x < left + width; x++) {
            for (int y = top; y < top + height; y++) {
                colours.add(new Color(image.getRGB(x, y)));
            }
        }
        Color dark = Collections.max(colours, Comparator.comparingDouble(colour -> Contrast.of(colour, Color.WHITE)));
        Color light = Collections.max(colours, Comparator.comparingDouble(colour -> Contrast.of(colour, Color.BLACK)));
        return Contrast.of(dark, light);
    }

    private static <T> T onEventThread(Supplier<T> work) {
        return EventThread.isCurrent() ? work.get() : EventThread.get(work);
    }
}
