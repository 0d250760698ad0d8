package org.sami.ui.geo;

import java.util.Locale;
import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/** The Military Grid Reference System: the UTM grid with letters for its squares of 100 km, and metres inside of one. */
final class MilitaryGrid {
    private static final double SQUARE_M = 100_000;
    private static final double CYCLE_M = 2_000_000;
    private static final double NORTHINGS_END_M = 10_000_000;
    private static final String[] COLUMNS = {"STUVWXYZ", "ABCDEFGH", "JKLMNPQR"};
    private static final String ROWS = "ABCDEFGHJKLMNPQRSTUV";
    private static final int EVEN_ZONES_BEGIN_AT = 5;

    private MilitaryGrid() {}

    /** {@code 32T PR 33842 62301}: metres are cut and not rounded, as the grid is defined. */
    static String format(UtmPoint point) {
        int column = (int) (point.eastingM() / SQUARE_M) - 1;
        int row = (int) (point.northingM() % CYCLE_M / SQUARE_M);
        return String.format(
                Locale.ROOT,
                "%d%s %s%s %05d %05d",
                point.zone(),
                point.band(),
                COLUMNS[point.zone() % COLUMNS.length].charAt(column),
                ROWS.charAt((row + firstRow(point.zone())) % ROWS.length()),
                (int) (point.eastingM() % SQUARE_M),
                (int) (point.northingM() % SQUARE_M));
    }

    private static int firstRow(int zone) {
        return zone % 2 == 0 ? EVEN_ZONES_BEGIN_AT : 0;
    }

    /** The point at so many metres in a square; none where there is no such square in the zone's band. */
    static Optional<GeoPoint> point(int zone, char band, char column, char row, double eastM, double northM) {
        int columnIndex = COLUMNS[zone % COLUMNS.length].indexOf(column);
        int rowIndex = ROWS.indexOf(row);
        if (columnIndex < 0 || rowIndex < 0) {
            return Optional.empty();
        }
        double eastingM = (columnIndex + 1) * SQUARE_M + eastM;
        int rowOfZone = Math.floorMod(rowIndex - firstRow(zone), ROWS.length());
        for (double northingM = rowOfZone * SQUARE_M + northM; northingM < NORTHINGS_END_M; northingM += CYCLE_M) {
            UtmPoint candidate = new UtmPoint(zone, band, eastingM, northingM);
            Optional<GeoPoint> at = candidate.point().filter(point -> candidate.isInBand(point.latDeg()));
            if (at.isPresent()) {
                return at;
            }
        }
        return Optional.empty();
    }
}
