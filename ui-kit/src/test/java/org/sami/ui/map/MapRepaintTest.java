package org.sami.ui.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.palette.IdentityMark;
import org.sami.palette.Theme;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.look.Look;

/** What is kept from one painting to the next is never shown when it is old. The theme is the whole process's. */
@Isolated
class MapRepaintTest {
    private final MapView map = new MapView();

    @AfterEach
    void close() {
        Look.apply(Theme.LIGHT, 100);
        map.close();
    }

    @Test
    void aTrackIsSeenToItsEndAsItGrows() {
        TrackLayer tracks = map.layers().add(new TrackLayer("tracks", "Tracks"));
        List<GeoPoint> points = new ArrayList<>(List.of(MapScenes.at(-100, 0), MapScenes.at(-90, 0)));
        tracks.show(List.of(track(points)));
        MapScenes.size(map, 800, 600);
        map.setGrid(false);
        map.centre(MapScenes.LAKE);

        for (int east = -80; east <= 100; east++) {
            points.add(MapScenes.at(east, 0));
            tracks.show(List.of(track(points)));
            assertThat(isWater(MapScenes.paint(map), MapScenes.at(east - 0.5, 0)))
                    .as("the track is not seen %s m east", east)
                    .isFalse();
        }
        tracks.show(List.of());

        assertThat(isWater(MapScenes.paint(map), MapScenes.at(-95, 0))).isTrue();
    }

    @Test
    void whatIsKeptIsAsWhatIsPaintedAnew() {
        MovingFleet fleet = new MovingFleet(5, 60);
        try (MapView moved = fleet.map()) {
            MapScenes.size(moved, 800, 600);
            moved.fitAll();
            BufferedImage before = MapScenes.paint(moved);
            moved.press(MapKey.LEFT);
            MapScenes.paint(moved);
            moved.press(MapKey.RIGHT);

            assertThat(pixels(MapScenes.paint(moved))).isEqualTo(pixels(before));

            Look.apply(Theme.DARK, 100);
            assertThat(pixels(MapScenes.paint(moved))).isNotEqualTo(pixels(before));
            Look.apply(Theme.LIGHT, 100);
            assertThat(pixels(MapScenes.paint(moved))).isEqualTo(pixels(before));
        }
    }

    @Test
    void inACrowdTheChosenVehicleKeepsItsName() {
        VehicleLayer vehicles = map.layers().add(new VehicleLayer("vehicles", "Vehicles"));
        MapScenes.size(map, 800, 600);
        map.setGrid(false);
        map.centre(MapScenes.LAKE);
        List<ShownVehicle> alike = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            alike.add(vehicle("v" + i, false));
        }
        vehicles.show(alike);
        int without = inked(MapScenes.paint(map));
        alike.set(30, vehicle("the chosen vehicle of a long name", true));
        vehicles.show(alike);

        assertThat(inked(MapScenes.paint(map))).isGreaterThan(without + 1500);
    }

    private static ShownVehicle vehicle(String name, boolean selected) {
        return new ShownVehicle(name, name, new IdentityMark(0), MapScenes.LAKE, 0, 0, 0, 0, selected);
    }

    private static Track track(List<GeoPoint> points) {
        return new Track("proxy-1", new IdentityMark(11), points);
    }

    private boolean isWater(BufferedImage image, GeoPoint at) {
        int x = (int) Math.round(map.frame().px(at));
        int y = (int) Math.round(map.frame().py(at));
        return image.getRGB(x, y) == image.getRGB(400, 20);
    }

    /** How many pixels are not water. */
    private static int inked(BufferedImage image) {
        int water = image.getRGB(400, 20);
        return (int) java.util.Arrays.stream(pixels(image))
                .filter(pixel -> pixel != water)
                .count();
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight() - 60, null, 0, image.getWidth());
    }
}
