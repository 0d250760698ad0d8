package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.palette.Contrast;
import org.sami.palette.IdentityMark;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoShape;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;

/** Names of vehicles, points and areas that lie close to one another: none hides another. */
@Isolated("the look is one for all windows of a process")
class MapNamesTest {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 500;
    private static final MapTool NO_TOOL = new MapTool() {};
    private static final double WORLD_PX = Math.scalb(256.0, 16); // about 1.7 m a pixel

    private final List<Rectangle2D> names = new ArrayList<>();

    /** Remembers where names are written. */
    private final class Written extends MapLabels {
        @Override
        void addText(double left, double top, double width, double height) {
            super.addText(left, top, width, height);
            names.add(new Rectangle2D.Double(left, top, width, height));
        }
    }

    @Test
    void atTheQuayNoNameHidesAnother() {
        VehicleLayer boats = new VehicleLayer("boats", "Boats");
        boats.show(row(6, ""));
        PointLayer places = new PointLayer("places", "Places");
        places.show(List.of(
                new PointLayer.MapPoint("home", "@home", MapScenes.at(-6, 4)),
                new PointLayer.MapPoint("station", "@station", MapScenes.at(30, -10)),
                new PointLayer.MapPoint("safe", "@safePlace", MapScenes.at(4, -30))));
        AreaLayer areas = new AreaLayer("areas", "Areas");
        areas.show(List.of(
                new ShownArea("water", "@water", MapScenes.square(0, 0, 200), ShownArea.Kind.FENCE),
                new ShownArea("area", "@area", MapScenes.square(20, -20, 30), ShownArea.Kind.WORK)));

        paint(areas, places, boats);

        assertThat(names).as("six boats, the areas, and points that have room").hasSizeBetween(8, 11);
        assertNoneHidesAnother();
    }

    @Test
    void ofManyBoatsTheNamesThatHaveRoomAreWritten() {
        VehicleLayer boats = new VehicleLayer("boats", "Boats");
        boats.show(row(20, "the boat of crew "));

        paint(boats);

        assertThat(names).hasSizeGreaterThan(6);
        assertNoneHidesAnother();
    }

    @Test
    void ofBoatsThatLieCloseTogetherNoNameCoversLettersOfAnother() {
        VehicleLayer boats = new VehicleLayer("boats", "Boats");
        boats.show(IntStream.range(0, 20)
                .mapToObj(i -> boat("boat" + (i + 1), MapScenes.at(i % 5 * 40, -i / 5 * 17)))
                .toList());

        paint(boats);

        assertThat(names).hasSizeGreaterThan(5);
        assertNoneHidesAnother();
    }

    @Test
    void noLineThatIsDrawnCrossesAName() {
        VehicleLayer boats = new VehicleLayer("boats", "Boats");
        boats.show(List.of(boat("anna", MapScenes.at(0, 0))));
        GeoSketch path = new GeoSketch(GeoShape.PATH);
        path.add(MapScenes.at(-100, 0));
        path.add(MapScenes.at(100, 0)); // through the boat and the name next to it

        BufferedImage image =
                paint(Set.of(), new SketchTool(path, false, NO_TOOL, MapNamesTest::frame, () -> {}, () -> {}), boats);

        int line = SemanticColor.MAP_HIGHLIGHT.get().getRGB();
        assertThat(names).as("the boat's and the path's length").hasSize(2);
        for (Rectangle2D name : names) {
            List<Integer> seen = new ArrayList<>();
            for (int x = (int) name.getMinX(); x < name.getMaxX(); x++) {
                for (int y = (int) name.getMinY(); y < name.getMaxY(); y++) {
                    seen.add(image.getRGB(x, y));
                }
            }
            assertThat(seen).as("pixels of a name").isNotEmpty().doesNotContain(line);
        }
    }

    @Test
    void aNameThatHasRoomStaysWhereItStood() {
        VehicleLayer boats = new VehicleLayer("boats", "Boats");
        boats.show(List.of(boat("anna", MapScenes.at(0, 0)), boat("bert", MapScenes.at(12, 0))));
        paint(boats);
        Rectangle2D before = names.get(1);

        boats.show(List.of(boat("anna", MapScenes.at(-80, 60)), boat("bert", MapScenes.at(12, 0))));
        paint(boats);

        assertThat(names.get(1)).isEqualTo(before);
    }

    /** As the window says: 4.5:1, in the theme for bright sun 7:1. */
    @ParameterizedTest
    @EnumSource(Theme.class)
    void namesAreReadWhereOtherThingsAreSpokenOf(Theme theme) {
        Look.apply(theme, 100);
        try {
            VehicleLayer boats = new VehicleLayer("boats", "Boats");
            boats.show(List.of(boat("mmmmm", MapScenes.at(0, 0)), boat("bert", MapScenes.at(80, 60))));

            BufferedImage image = paint(Set.of("bert"), boats);

            Rectangle2D name = names.get(1); // the important one comes first
            Color lightest = SemanticColor.MAP_WATER.get();
            Color darkest = lightest;
            for (int x = (int) name.getMinX() + 1; x < name.getMaxX() - 1; x++) {
                for (int y = (int) name.getMinY() + 1; y < name.getMaxY() - 1; y++) {
                    Color there = new Color(image.getRGB(x, y));
                    lightest = sum(there) > sum(lightest) ? there : lightest;
                    darkest = sum(there) < sum(darkest) ? there : darkest;
                }
            }
            assertThat(Contrast.of(lightest, darkest)).isGreaterThanOrEqualTo(theme == Theme.SUN ? 7 : 4.5);
        } finally {
            Look.apply(Theme.LIGHT, 100);
        }
    }

    private static int sum(Color color) {
        return color.getRed() + color.getGreen() + color.getBlue();
    }

    private void assertNoneHidesAnother() {
        for (int i = 0; i < names.size(); i++) {
            for (Rectangle2D other : names.subList(i + 1, names.size())) {
                Rectangle2D both = names.get(i).createIntersection(other);
                double hidden = both.isEmpty() ? 0 : both.getWidth() * both.getHeight();
                assertThat(hidden / (other.getWidth() * other.getHeight()))
                        .as("part of a name that another hides")
                        .isLessThanOrEqualTo(0.03);
            }
        }
    }

    private static List<ShownVehicle> row(int count, String prefix) {
        List<ShownVehicle> row = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            row.add(boat(prefix + "b" + i, MapScenes.at(0, -22 * i)));
        }
        return row;
    }

    private static ShownVehicle boat(String name, GeoPoint at) {
        return new ShownVehicle(name, name, new IdentityMark(0), at, 0, 0, 0, 0, false);
    }

    /** As a map paints them: the lowest layer first, the names of the topmost first. */
    private void paint(MapLayer... layers) {
        paint(Set.of(), layers);
    }

    /** The same where some things are spoken of. */
    private BufferedImage paint(Set<String> highlighted, MapLayer... layers) {
        return paint(highlighted, NO_TOOL, layers);
    }

    private BufferedImage paint(Set<String> highlighted, MapTool tool, MapLayer... layers) {
        names.clear();
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setFont(Fonts.small());
        g.setColor(SemanticColor.MAP_WATER.get());
        g.fillRect(0, 0, WIDTH, HEIGHT);
        MapCanvas.paint(new MapPaint(g, frame(), highlighted, new Written(), false), List.of(layers), tool);
        g.dispose();
        return image;
    }

    private static MapFrame frame() {
        return new MapFrame(
                Mercator.x(MapScenes.LAKE.lonDeg()), Mercator.y(MapScenes.LAKE.latDeg()), WORLD_PX, WIDTH, HEIGHT);
    }
}
