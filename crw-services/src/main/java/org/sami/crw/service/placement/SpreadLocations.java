package org.sami.crw.service.placement;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.prep.PreparedGeometry;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;
import org.sami.crw.service.Interruption;
import org.sami.crw.service.water.Areas;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Locations spread over an area on a hexagonal grid: as many as fit at a spacing, each in the area and clear of what is forbidden. */
public final class SpreadLocations {
    /** More are no plan but a mistake in the spacing. */
    private static final int MOST = 100_000;

    private SpreadLocations() {}

    /**
     * The locations, by rows from the south.
     *
     * @param spacingM distance between two neighbours; locations keep half of it from forbidden areas, and at least the boats' cross-track error
     * @throws IllegalArgumentException for an area that is no simple polygon, or a spacing with too many locations
     */
    public static List<GeoPoint> over(GeoArea area, double spacingM, Water water) {
        if (!(spacingM > 0)) {
            throw new IllegalArgumentException("The spacing is more than 0 m, not " + spacingM);
        }
        Polygon polygon = Areas.polygon(area, water.plane(), "The area");
        PreparedGeometry prepared = PreparedGeometryFactory.prepare(polygon);
        Envelope extent = polygon.getEnvelopeInternal();
        double rowM = spacingM * Math.sqrt(3) / 2;
        if (extent.getWidth() / spacingM * (extent.getHeight() / rowM) > MOST) {
            throw new IllegalArgumentException(
                    "At a spacing of " + spacingM + " m the area has more than " + MOST + " locations");
        }
        List<GeoPoint> spread = new ArrayList<>();
        int rows = (int) Math.floor(extent.getHeight() / rowM);
        double firstX = extent.getMinX() + extent.getWidth() % spacingM / 2;
        for (int row = 0; row <= rows; row++) {
            Interruption.check();
            double y = extent.getMinY() + (extent.getHeight() - rows * rowM) / 2 + row * rowM;
            double shiftM = row % 2 * spacingM / 2;
            for (double x = firstX + shiftM; x <= extent.getMaxX(); x += spacingM) {
                Coordinate place = new Coordinate(x, y);
                GeoPoint point = Areas.point(place, water.plane());
                if (prepared.covers(polygon.getFactory().createPoint(place))
                        && water.clearanceM(point)
                                >= Math.max(spacingM / 2, water.margin().pathM())) {
                    spread.add(point);
                }
            }
        }
        return spread;
    }
}
