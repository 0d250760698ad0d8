package org.sami.ui.geo;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.value.GeoPoint;

/** Reads coordinates as people type them, in any {@link CoordinateNotation}, or with degrees, minutes and seconds. */
public final class Coordinates {
    /** What to type, for a field's hint and for messages. */
    public static final String EXAMPLES =
            "45.7, 10.72 or 45° 42.0' N, 10° 43.2' E or 32T 633842 5062301 or 32T PR 33842 62301";

    private static final String ANGLE =
            "([+-]?\\d+(?:\\.\\d+)?)\\s*[°d]?\\s*(?:(\\d+(?:\\.\\d+)?)\\s*['′m]?\\s*)?(?:(\\d+(?:\\.\\d+)?)\\s*[\"″s]?\\s*)?";
    private static final Pattern ANGLES =
            Pattern.compile(ANGLE + "([NS])\\s*[,;]?\\s*" + ANGLE + "([EW])", Pattern.CASE_INSENSITIVE);
    private static final Pattern DECIMAL =
            Pattern.compile("([+-]?\\d+(?:\\.\\d+)?)\\s*°?\\s*[,;\\s]\\s*([+-]?\\d+(?:\\.\\d+)?)\\s*°?");
    private static final Pattern UTM = Pattern.compile(
            "(\\d{1,2})\\s*([C-HJ-NP-X])\\s+(\\d{6}(?:\\.\\d+)?)m?E?\\s*[,;\\s]\\s*(\\d{1,8}(?:\\.\\d+)?)m?N?");
    private static final Pattern MGRS = Pattern.compile(
            "(\\d{1,2})\\s*([C-HJ-NP-X])\\s*([A-HJ-NP-Z])([A-HJ-NP-V])\\s*(\\d{1,5}\\s+\\d{1,5}|\\d{2,10})");
    private static final int FULL_DIGITS = 5;
    private static final int MINUTES = 60;

    private Coordinates() {}

    /** The point at altitude zero that a text names; none where it names none. */
    public static Optional<GeoPoint> parse(String text) {
        String stripped = text.strip();
        Matcher decimal = DECIMAL.matcher(stripped);
        if (decimal.matches()) {
            return point(Double.parseDouble(decimal.group(1)), Double.parseDouble(decimal.group(2)));
        }
        Matcher angles = ANGLES.matcher(stripped);
        if (angles.matches()) {
            return angle(angles, 1).flatMap(lat -> angle(angles, 5).flatMap(lon -> point(lat, lon)));
        }
        String capitals = stripped.toUpperCase(Locale.ROOT);
        Matcher utm = UTM.matcher(capitals);
        if (utm.matches()) {
            return zone(utm)
                    .flatMap(zone -> new UtmPoint(
                                    zone,
                                    utm.group(2).charAt(0),
                                    Double.parseDouble(utm.group(3)),
                                    Double.parseDouble(utm.group(4)))
                            .point());
        }
        Matcher mgrs = MGRS.matcher(capitals);
        return mgrs.matches() ? zone(mgrs).flatMap(zone -> inSquare(zone, mgrs)) : Optional.empty();
    }

    /** Degrees of the four groups from one on: degrees, minutes, seconds, letter. */
    private static Optional<Double> angle(Matcher groups, int first) {
        double minutes = number(groups.group(first + 1));
        double seconds = number(groups.group(first + 2));
        if (minutes >= MINUTES || seconds >= MINUTES) {
            return Optional.empty();
        }
        double degrees = number(groups.group(first)) + (minutes + seconds / MINUTES) / MINUTES;
        String letter = groups.group(first + 3).toUpperCase(Locale.ROOT);
        return Optional.of(letter.equals("S") || letter.equals("W") ? -degrees : degrees);
    }

    private static double number(String text) {
        return text == null ? 0 : Double.parseDouble(text);
    }

    private static Optional<GeoPoint> point(double latDeg, double lonDeg) {
        boolean onEarth = Math.abs(latDeg) <= 90 && Math.abs(lonDeg) <= 180;
        return onEarth ? Optional.of(GeoPoint.of(latDeg, lonDeg)) : Optional.empty();
    }

    private static Optional<Integer> zone(Matcher groups) {
        int zone = Integer.parseInt(groups.group(1));
        return zone >= 1 && zone <= MINUTES ? Optional.of(zone) : Optional.empty();
    }

    private static Optional<GeoPoint> inSquare(int zone, Matcher groups) {
        String digits = groups.group(5);
        String[] halves = digits.matches(".*\\s.*")
                ? digits.split("\\s+", 2)
                : new String[] {digits.substring(0, digits.length() / 2), digits.substring(digits.length() / 2)};
        if (halves[0].length() != halves[1].length()) {
            return Optional.empty();
        }
        double unitM = Math.pow(10, FULL_DIGITS - halves[0].length());
        return MilitaryGrid.point(
                zone,
                groups.group(2).charAt(0),
                groups.group(3).charAt(0),
                groups.group(4).charAt(0),
                Integer.parseInt(halves[0]) * unitM,
                Integer.parseInt(halves[1]) * unitM);
    }
}
