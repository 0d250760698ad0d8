package org.sami.ui.geo;

import org.sami.spn.value.GeoPoint;

/**
 * Which part of the world a map shows: the conversion between points and pixels, north up.
 *
 * @param centreX of the middle pixel, on the unit square of {@link Mercator}
 * @param centreY of the middle pixel
 * @param worldPx how many pixels the unit square is wide
 * @param width of the map, in pixels
 * @param height of the map, in pixels
 */
public record MapFrame(double centreX, double centreY, double worldPx, int width, int height) {
    /** The x in pixels, from the map's left edge, of an x on the unit square. */
    public double px(double x) {
        return (x - centreX) * worldPx + width / 2.0;
    }

    /** The y in pixels, from the map's upper edge, of a y on the unit square. */
    public double py(double y) {
        return (y - centreY) * worldPx + height / 2.0;
    }

    /** The x of a point in pixels. */
    public double px(GeoPoint point) {
        return px(Mercator.x(point.lonDeg()));
    }

    /** The y of a point in pixels. */
    public double py(GeoPoint point) {
        return py(Mercator.y(point.latDeg()));
    }

    /** The point at a pixel, at altitude zero. */
    public GeoPoint point(double px, double py) {
        return Mercator.point(centreX + (px - width / 2.0) / worldPx, centreY + (py - height / 2.0) / worldPx);
    }

    /** How many metres a pixel is in the middle of the map. */
    public double metresPerPixel() {
        return Mercator.metresPerWorld(point(width / 2.0, height / 2.0).latDeg()) / worldPx;
    }

    /** Whether a point lies on the map. */
    public boolean isShown(GeoPoint point) {
        return px(point) >= 0 && px(point) <= width && py(point) >= 0 && py(point) <= height;
    }

    /** How far apart a point and a pixel are, in pixels. */
    public double distancePx(GeoPoint point, double px, double py) {
        return Math.hypot(px(point) - px, py(point) - py);
    }
}
