package org.sami.crw.service.coverage;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.locationtech.jts.geom.Geometry;

/**
 * To and fro in lanes, as one mows a lawn (thesis 6.2). One tour through the whole area is cut into pieces of equal length, one for
 * each boat, so no boat's share lies in another's. The pieces are given out so that the boats' ways to them are least in sum, and
 * each is driven from its nearer end.
 *
 * <p>Tracks never leave the area and enter none of its holes; where the area is in parts, boats cross from one to the next through
 * what is not forbidden. Lanes end a little before the area's edge, half a metre at most.
 */
public final class LawnMower implements CoverageAlgorithm {
    @Override
    public Coverage cover(CoverageProblem problem) {
        CoverageRegion lawn = new CoverageRegion(problem);
        Map<String, String> noWay = new LinkedHashMap<>();
        Map<String, CoverageShare> shares = TrackShares.of(problem, lawn.tour(), lawn.water(), noWay);
        Geometry rest = lawn.rest(List.copyOf(shares.values()));
        return new Coverage(shares, noWay, lawn.areaM2(), rest.getArea(), UncoveredArea.areas(rest, lawn.plane()));
    }
}
