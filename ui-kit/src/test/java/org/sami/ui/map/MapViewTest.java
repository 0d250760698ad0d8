package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.GeoMeasure;
import org.sami.ui.geo.GeoShape;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Mercator;

class MapViewTest {
    private final MapView map = MapScenes.fleet(20, 100);

    @BeforeEach
    void size() {
        MapScenes.size(map, 1200, 800);
        map.fitAll();
    }

    @AfterEach
    void close() {
        map.close();
    }

    @Test
    void showsAllThatLayersHave() {
        VehicleLayer vehicles = (VehicleLayer) map.layers().find("vehicles").orElseThrow();

        assertThat(vehicles.vehicles()).allMatch(vehicle -> map.frame().isShown(vehicle.at()));
    }

    @Test
    void whatIsFittedFillsTheMap() {
        GeoBounds all = map.layers().bounds().orElseThrow();

        for (int width : List.of(500, 700, 900, 1200)) {
            MapScenes.size(map, width, 800);
            map.fit(all);
            MapFrame frame = map.frame();
            double wide = frame.px(Mercator.x(all.eastDeg())) - frame.px(Mercator.x(all.westDeg()));
            double high = frame.py(Mercator.y(all.southDeg())) - frame.py(Mercator.y(all.northDeg()));

            assertThat(Math.max(wide / frame.width(), high / frame.height()))
                    .as("part of a map %s px wide", width)
                    .isBetween(0.7, 1.0);
        }
    }

    @Test
    void aHiddenLayerIsNotPainted() {
        BufferedImage before = MapScenes.paint(map);

        map.layers().all().forEach(layer -> layer.setVisible(false));
        map.setGrid(false);
        BufferedImage after = MapScenes.paint(map);

        assertThat(colours(before)).isGreaterThan(40);
        assertThat(colours(after)).isLessThan(colours(before) / 4);
    }

    @Test
    void whatIsNotSpokenOfIsDimmed() {
        int bright = colourAt(MapScenes.paint(map), vehicle(5).at());
        map.highlight(Set.of("proxy-1"));
        assertThat(colourAt(MapScenes.paint(map), vehicle(5).at())).isNotEqualTo(bright);
        map.highlight(Set.of("proxy-5"));
        assertThat(colourAt(MapScenes.paint(map), vehicle(5).at())).isEqualTo(bright);
    }

    @Test
    void aNameIsNotHiddenBelowWhatIsSaidOnTheMap() {
        map.setHint("anna: 82 m, about 55 s, 2 % of a full charge, and home again");
        GeoPoint below = map.frame().point(600, map.frame().height() - 62); // in the middle of the plate
        VehicleLayer vehicles = (VehicleLayer) map.layers().find("vehicles").orElseThrow();
        ShownVehicle one = vehicles.vehicles().get(0);
        vehicles.show(List.of(named(one, "anna", below)));
        BufferedImage anna = MapScenes.paint(map);
        vehicles.show(List.of(named(one, "nobody", below)));
        BufferedImage nobody = MapScenes.paint(map);

        assertThat(different(anna, nobody)).isGreaterThan(50);
    }

    private static ShownVehicle named(ShownVehicle one, String name, GeoPoint at) {
        return new ShownVehicle(one.id(), name, one.mark(), at, 0, 0, 0, 0, true);
    }

    /** How many pixels are clearly of another brightness: what shines through a plate does not count. */
    private static long different(BufferedImage one, BufferedImage two) {
        return IntStream.range(0, one.getWidth() * one.getHeight())
                .filter(i -> Math.abs(green(one, i) - green(two, i)) > 60)
                .count();
    }

    private static int green(BufferedImage picture, int pixel) {
        return picture.getRGB(pixel % picture.getWidth(), pixel / picture.getWidth()) >> 8 & 0xff;
    }

    @Test
    void theWheelZoomsAroundThePointer() {
        GeoPoint under = map.frame().point(300, 200);
        double before = map.frame().metresPerPixel();

        map.canvas()
                .dispatchEvent(
                        new MouseWheelEvent(map.canvas(), MouseEvent.MOUSE_WHEEL, 0, 0, 300, 200, 0, false, 0, 1, -1));

        assertThat(map.frame().metresPerPixel()).isLessThan(before * 0.51);
        assertThat(map.frame().distancePx(under, 300, 200)).isLessThan(1.5);
    }

    @Test
    void draggingPans() {
        GeoPoint under = map.frame().point(20, 20);

        drag(20, 20, 120, 90);

        assertThat(map.frame().distancePx(under, 120, 90)).isLessThan(1.5);
    }

    @Test
    void aClickTellsWhatLiesThere() {
        List<MapClick> clicks = new ArrayList<>();
        map.addMapListener(new MapListener() {
            @Override
            public void clicked(MapClick click) {
                clicks.add(click);
            }
        });

        click(vehicle(8).at(), 1);
        click(5, 5, 1);

        assertThat(clicks).extracting(MapClick::item).containsExactly(Optional.of("proxy-8"), Optional.empty());
    }

    @Test
    void drawsAPathByClicks() {
        GeoSketch sketch = new GeoSketch(GeoShape.PATH);
        List<Boolean> ended = new ArrayList<>();
        map.edit(sketch, ended::add);
        map.layers().all().forEach(layer -> layer.setVisible(false));
        GeoPoint first = map.frame().point(100, 100);

        click(100, 100, 1);
        click(400, 100, 1);
        click(400, 300, 1);
        drag(400, 300, 500, 310);
        map.press(MapKey.FINISH);

        assertThat(ended).containsExactly(true);
        assertThat(map.isEditing()).isFalse();
        List<GeoPoint> points = ((GeoPath) sketch.value().orElseThrow()).points();
        assertThat(points).hasSize(3);
        assertThat(GeoMeasure.metres(points.get(0), first)).isLessThan(0.01);
        assertThat(map.frame().distancePx(points.get(2), 500, 310)).isLessThan(0.01);
    }

    @Test
    void drawsAnAreaByKeysAlone() {
        GeoSketch sketch = new GeoSketch(GeoShape.AREA);
        List<Boolean> ended = new ArrayList<>();
        map.edit(sketch, ended::add);

        map.press(MapKey.ADD);
        map.press(MapKey.RIGHT); // moves the chosen corner, and not the map
        map.press(MapKey.FINISH); // is no area yet
        map.press(MapKey.CANCEL);

        assertThat(ended).containsExactly(false);
        assertThat(sketch.points()).hasSize(1);
        assertThat(map.frame()
                        .distancePx(sketch.points().get(0), 601, map.frame().height() / 2.0))
                .isLessThan(0.01);
    }

    @Test
    void aMapInAFormSaysWhatIsMissingAndNothingWhenAllIsThere() {
        for (boolean form : new boolean[] {true, false}) {
            map.setInForm(form);
            GeoSketch sketch = new GeoSketch(GeoShape.POINT);
            map.edit(sketch, kept -> {});
            assertThat(((MapCanvas) map.canvas()).said()).isEqualTo("Click 1 point on the map");

            sketch.add(GeoPoint.of(45.4, 10.9));

            assertThat(((MapCanvas) map.canvas()).said().isEmpty()).isEqualTo(form);
        }
    }

    @Test
    void aPointSnapsToAnArea() {
        GeoArea area = MapScenes.square(-60, 60, 70);
        GeoSketch sketch = new GeoSketch(GeoShape.POINT);
        map.edit(sketch, kept -> {});
        GeoPoint corner = area.outline().get(3);

        click((int) map.frame().px(corner) + 3, (int) map.frame().py(corner) - 4, 1);

        assertThat(sketch.value()).contains((Value) corner);
    }

    private ShownVehicle vehicle(int index) {
        return ((VehicleLayer) map.layers().find("vehicles").orElseThrow())
                .vehicles()
                .get(index);
    }

    private int colourAt(BufferedImage image, GeoPoint at) {
        return image.getRGB((int) Math.round(map.frame().px(at)), (int)
                Math.round(map.frame().py(at)));
    }

    private static long colours(BufferedImage image) {
        return java.util.Arrays.stream(
                        image.getRGB(0, 0, image.getWidth(), image.getHeight() - 60, null, 0, image.getWidth()))
                .distinct()
                .count();
    }

    private void click(GeoPoint at, int count) {
        click((int) Math.round(map.frame().px(at)), (int) Math.round(map.frame().py(at)), count);
    }

    private void click(int x, int y, int count) {
        mouse(MouseEvent.MOUSE_PRESSED, x, y, count);
        mouse(MouseEvent.MOUSE_RELEASED, x, y, count);
    }

    private void drag(int x, int y, int toX, int toY) {
        mouse(MouseEvent.MOUSE_PRESSED, x, y, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, (x + toX) / 2, (y + toY) / 2, 0);
        mouse(MouseEvent.MOUSE_DRAGGED, toX, toY, 0);
        mouse(MouseEvent.MOUSE_RELEASED, toX, toY, 1);
    }

    private void mouse(int id, int x, int y, int count) {
        map.canvas()
                .dispatchEvent(new MouseEvent(
                        map.canvas(), id, 0, MouseEvent.BUTTON1_DOWN_MASK, x, y, count, false, MouseEvent.BUTTON1));
    }
}
