package org.sami.crw.service.coverage;

import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Tracks of boats that cover an area together.
 *
 * @param shares the share of each boat that has one
 * @param noWay the boats that cannot reach the area, with reasons; they have no share
 * @param areaM2 the area to cover, without no-go areas
 * @param uncoveredM2 the part of it farther from every track than half the spacing
 * @param rest that part
 * @param unreached the parts of the area that no boat can reach, because no-go areas enclose them; they are in the rest
 * @param beyondCharge the stretches for which no charge lasts, at most one in each part of the area
 */
public record Coverage(
        Map<String, CoverageShare> shares,
        Map<String, String> noWay,
        double areaM2,
        double uncoveredM2,
        List<GeoArea> rest,
        List<Unreached> unreached,
        List<BeyondCharge> beyondCharge) {
    /**
     * A part of the area that no boat can get to.
     *
     * @param near a point in it
     */
    public record Unreached(GeoPoint near, double areaM2) {}

    /**
     * A stretch of track for which no charge lasts.
     *
     * @param near a point of it
     * @param recharged whether boats drive it after a battery swap on the way, each its share; otherwise no boat drives it
     * @param home whether the reason is that charges also have to last for the ways home
     */
    public record BeyondCharge(GeoPoint near, double trackM, boolean recharged, boolean home) {}

    public Coverage {
        shares = Collections.unmodifiableMap(new LinkedHashMap<>(shares));
        noWay = Collections.unmodifiableMap(new LinkedHashMap<>(noWay));
        rest = List.copyOf(rest);
        unreached = List.copyOf(unreached);
        beyondCharge = List.copyOf(beyondCharge);
    }

    /** Sum of the lengths of all tracks, without the boats' ways to them. */
    public double trackM() {
        return shares.values().stream().mapToDouble(CoverageShare::trackM).sum();
    }

    /** The longest track, likewise. */
    public double longestM() {
        return shares.values().stream().mapToDouble(CoverageShare::trackM).max().orElse(0);
    }

    /** Area, length and rest as people say them. */
    public String words() {
        int boats = shares.size();
        return String.format(
                        Locale.ROOT,
                        "%.0f m² in %.0f m of track, for %d boat%s at most %.0f m; %.1f m² (%.2f %%) stay uncovered",
                        areaM2,
                        trackM(),
                        boats,
                        boats == 1 ? "" : "s",
                        longestM(),
                        uncoveredM2,
                        100 * uncoveredM2 / areaM2)
                + unreached.stream()
                        .map(part -> String.format(
                                Locale.ROOT,
                                "; no boat can reach %.0f m² near %.5f,%.5f",
                                part.areaM2(),
                                part.near().latDeg(),
                                part.near().lonDeg()))
                        .collect(Collectors.joining())
                + beyondCharge.stream().map(Coverage::words).collect(Collectors.joining());
    }

    private static String words(BeyondCharge stretch) {
        return stretch.recharged()
                ? String.format(
                        Locale.ROOT,
                        "; that is up to %.0f m a boat more than its charge is sure to last for: batteries are to be swapped on the way",
                        stretch.trackM())
                : String.format(
                        Locale.ROOT,
                        "; charges do not last for %.0f m of track more%s, near %.5f,%.5f",
                        stretch.trackM(),
                        stretch.home() ? " and the ways home" : "",
                        stretch.near().latDeg(),
                        stretch.near().lonDeg());
    }

    /** What the operator is to be asked before boats begin: charges do not last for all, and nothing is swapped on the way. */
    public Optional<String> doubt() {
        return beyondCharge.stream()
                .filter(stretch -> !stretch.recharged())
                .max(Comparator.comparingDouble(BeyondCharge::trackM))
                .map(stretch -> String.format(
                        Locale.ROOT,
                        "charges are sure to last for %.0f %% of the area%s: %.0f m² stay unexplored, most near %.5f,%.5f",
                        100 * (1 - uncoveredM2 / areaM2),
                        stretch.home() ? " and the ways home" : "",
                        uncoveredM2,
                        stretch.near().latDeg(),
                        stretch.near().lonDeg()));
    }
}
