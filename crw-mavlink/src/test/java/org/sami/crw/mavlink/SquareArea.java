package org.sami.crw.mavlink;

import java.util.List;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Areas of four corners along meridians and parallels, for tests of fences. */
final class SquareArea {
    private SquareArea() {}

    /**
     * An area.
     *
     * @param lat of its southern edge, in degrees
     * @param lon of its western edge, in degrees
     * @param size of each edge, in degrees
     */
    static GeoArea of(double lat, double lon, double size) {
        return new GeoArea(
                List.of(
                        GeoPoint.of(lat, lon),
                        GeoPoint.of(lat, lon + size),
                        GeoPoint.of(lat + size, lon + size),
                        GeoPoint.of(lat + size, lon)),
                List.of());
    }
}
