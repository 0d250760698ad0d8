package org.sami.crw.sim.run.settings;

import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.value.GeoPoint;

/**
 * Where on earth a run takes place, as far as the user has given it. Nothing else moves a run: neither what its plan names nor how many
 * boats it has (docs/command-line.md).
 *
 * @param centre of the square in which locations lie; empty = {@link #USUAL_CENTRE}, or the middle of boats behind TCP
 * @param quay the middle of the line in which boats of this process lie at the start; empty = {@link #QUAY_M} south of the square
 */
public record Site(Optional<GeoPoint> centre, Optional<GeoPoint> quay) {
    /** The default centre of runs in process: open water of Lake Garda. */
    public static final GeoPoint USUAL_CENTRE = GeoPoint.of(45.7000, 10.7200);

    /** The quay lies this far south of the square, in metres. */
    public static final double QUAY_M = 20;

    /** The plane of the simulated water is exact to about this distance from its centre, in metres. */
    public static final double REACH_M = FleetSettings.LONGEST_AREA_M;

    /** No place is given. */
    public static final Site USUAL = new Site(Optional.empty(), Optional.empty());

    private static final String CENTRE = "at";
    private static final String QUAY = "quay";

    /** Refuses a quay that is beyond the water. */
    public Site {
        Objects.requireNonNull(centre, "centre");
        Objects.requireNonNull(quay, "quay");
        GeoPoint middle = centre.orElse(USUAL_CENTRE);
        quay.filter(at -> !(plane(middle).distanceM(at.latDeg(), at.lonDeg()) <= REACH_M))
                .ifPresent(at -> {
                    throw new IllegalArgumentException("the quay is at most 20 km from the centre, " + words(middle)
                            + "; at " + words(at) + " it is not");
                });
    }

    /** Around a point, with the quay where it usually is. */
    public static Site at(GeoPoint centre) {
        return new Site(Optional.of(centre), Optional.empty());
    }

    /** The centre of a run in process. */
    public GeoPoint centreInProcess() {
        return centre.orElse(USUAL_CENTRE);
    }

    /**
     * The quay of a run in process.
     *
     * @param areaM side of the square, in metres
     */
    public GeoPoint quayInProcess(double areaM) {
        LocalFrame plane = plane(centreInProcess());
        double northM = -areaM / 2 - QUAY_M;
        return quay.orElseGet(() -> GeoPoint.of(plane.latDeg(0, northM), plane.lonDeg(0, northM)));
    }

    /** Latitude and longitude as the command line takes them: in degrees, to about a centimetre. */
    public static String words(GeoPoint point) {
        return String.format(Locale.ROOT, "%.7f,%.7f", point.latDeg(), point.lonDeg());
    }

    private static LocalFrame plane(GeoPoint origin) {
        return new LocalFrame(origin.latDeg(), origin.lonDeg());
    }

    /** As text by name, for the header of a journal; values not given are left out. */
    Map<String, String> toMap() {
        Map<String, String> map = new TreeMap<>();
        centre.ifPresent(at -> map.put(CENTRE, at.latDeg() + "," + at.lonDeg()));
        quay.ifPresent(at -> map.put(QUAY, at.latDeg() + "," + at.lonDeg()));
        return map;
    }

    /** Reads what {@link #toMap} wrote. */
    static Site fromMap(Map<String, String> map) {
        return new Site(point(map.get(CENTRE)), point(map.get(QUAY)));
    }

    private static Optional<GeoPoint> point(@Nullable String text) {
        if (text == null) {
            return Optional.empty();
        }
        int comma = text.indexOf(',');
        return Optional.of(GeoPoint.of(
                Double.parseDouble(text.substring(0, comma)), Double.parseDouble(text.substring(comma + 1))));
    }
}
