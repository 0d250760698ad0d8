package org.sami.crw.service.coverage;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Tracks of boats that cover an area together.
 *
 * @param shares the share of each boat that has one
 * @param noWay the boats that cannot get to the area, and why; they have no share
 * @param areaM2 what is to be covered: the area without what is not to be entered
 * @param uncoveredM2 what of it is farther from every track than half the spacing
 * @param rest that part
 * @param unreached the parts of the area that no boat can get to, as what is not to be entered lies all around them; they are in the rest
 */
public record Coverage(
        Map<String, CoverageShare> shares,
        Map<String, String> noWay,
        double areaM2,
        double uncoveredM2,
        List<GeoArea> rest,
        List<Unreached> unreached) {
    /**
     * A part of the area that no boat can get to.
     *
     * @param near a point in it
     */
    public record Unreached(GeoPoint near, double areaM2) {}

    public Coverage {
        shares = Collections.unmodifiableMap(new LinkedHashMap<>(shares));
        noWay = Collections.unmodifiableMap(new LinkedHashMap<>(noWay));
        rest = List.copyOf(rest);
        unreached = List.copyOf(unreached);
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
                        .collect(Collectors.joining());
    }
}
