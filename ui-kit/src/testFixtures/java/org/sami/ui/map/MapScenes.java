package org.sami.ui.map;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;

/** Maps with something on them, for tests and benchmarks, and how one is painted without a display. */
public final class MapScenes {
    /** The middle of it all. */
    public static final GeoPoint LAKE = GeoPoint.of(45.70, 10.72);

    private static final double DEGREES_PER_M = 1 / 111_200.0;

    private MapScenes() {}

    /** The point so many metres east and north of the lake's middle. */
    public static GeoPoint at(double eastM, double northM) {
        return GeoPoint.of(
                LAKE.latDeg() + northM * DEGREES_PER_M,
                LAKE.lonDeg() + eastM * DEGREES_PER_M / Math.cos(Math.toRadians(LAKE.latDeg())));
    }

    /** A map with vehicles, their tracks of {@code trackPoints} points and paths, areas, a fence and a heat map. */
    public static MapView fleet(int vehicles, int trackPoints) {
        return new MovingFleet(vehicles, trackPoints).map();
    }

    /** The areas and the heat map below a fleet. */
    static void addGround(MapView map) {
        AreaLayer areas = map.layers().add(new AreaLayer("areas", "Areas"));
        areas.show(List.of(
                new ShownArea("fence", "fence", square(0, 0, 190), ShownArea.Kind.FENCE),
                new ShownArea("explore", "area to explore", square(-60, 60, 70), ShownArea.Kind.WORK),
                new ShownArea("reeds", "reeds", square(110, -90, 40), ShownArea.Kind.NO_GO)));
        HeatLayer heat = map.layers().add(new HeatLayer("heat", "Temperature"));
        heat.show(Optional.of(heat()));
    }

    /** A square around a point so many metres east and north of the middle. */
    public static GeoArea square(double eastM, double northM, double halfM) {
        return new GeoArea(
                List.of(
                        at(eastM - halfM, northM - halfM),
                        at(eastM + halfM, northM - halfM),
                        at(eastM + halfM, northM + halfM),
                        at(eastM - halfM, northM + halfM)),
                List.of());
    }

    private static HeatMap heat() {
        List<Double> values = new ArrayList<>();
        for (int row = 0; row < 24; row++) {
            for (int column = 0; column < 24; column++) {
                double value = 14 + 6 * Math.exp(-(Math.pow(row - 9, 2) + Math.pow(column - 14, 2)) / 40.0);
                values.add(column < 2 ? Double.NaN : value);
            }
        }
        GeoPoint low = at(40, 20);
        GeoPoint high = at(140, 120);
        return new HeatMap(
                "Temperature",
                "°C",
                new GeoBounds(low.latDeg(), low.lonDeg(), high.latDeg(), high.lonDeg()),
                24,
                24,
                values,
                14,
                20,
                OptionalDouble.of(15));
    }

    /** Gives a component a size and lays it out, as a window would. */
    public static void size(Component component, int width, int height) {
        component.setSize(width, height);
        layOut(component);
    }

    private static void layOut(Component component) {
        component.doLayout();
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                layOut(child);
            }
        }
    }

    /** A picture of a component that was laid out. */
    public static BufferedImage paint(Component component) {
        BufferedImage image =
                new BufferedImage(component.getWidth(), component.getHeight(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        component.paint(g);
        g.dispose();
        return image;
    }
}
