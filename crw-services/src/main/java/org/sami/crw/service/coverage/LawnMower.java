package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.locationtech.jts.geom.Geometry;

/**
 * Covers an area in parallel lanes, as one mows a lawn (thesis 6.2). One tour through the whole area is cut into pieces of equal length, one for each
 * boat, so that shares do not overlap. The pieces are assigned so that the sum of the boats' ways to them is least, and each is driven from its
 * nearer end. Where no-go areas divide the area, each part has a tour of its own for the boats that can reach it; parts that none can reach are
 * named. Where a charge does not last for such a piece, pieces are as long as charges allow ({@link TourDivision}).
 *
 * <p>Tracks never leave the area, and keep the boats' cross-track error from its holes and from areas to avoid. Boats cross between parts of the area
 * outside forbidden areas. Lanes end up to half a metre before the area's edge.
 */
public final class LawnMower implements CoverageAlgorithm {
    @Override
    public Coverage cover(CoverageProblem asked) {
        CoverageRegion region = new CoverageRegion(asked);
        CoverageProblem problem = asked.outside(region.water());
        Map<String, String> noWay = new LinkedHashMap<>();
        List<CoveragePart> parts = region.parts();
        Map<String, CoveragePart> partOf = BoatsOfParts.of(problem, parts, noWay);
        Map<String, CoverageShare> found = new LinkedHashMap<>();
        List<Coverage.Unreached> unreached = new ArrayList<>();
        List<Coverage.BeyondCharge> beyond = new ArrayList<>();
        for (CoveragePart part : parts) {
            List<String> boats = problem.boats().keySet().stream()
                    .filter(boat -> partOf.get(boat) == part)
                    .toList();
            TrackShares.Divided divided = boats.isEmpty()
                    ? TrackShares.Divided.NOTHING
                    : TrackShares.of(problem.withBoats(boats), part.tour(), region.water(), noWay);
            divided.beyond().ifPresent(beyond::add);
            if (divided.shares().isEmpty() && divided.beyond().isEmpty()) {
                unreached.add(new Coverage.Unreached(part.place(), part.areaM2()));
            }
            found.putAll(divided.shares());
        }
        Map<String, CoverageShare> shares = new LinkedHashMap<>();
        problem.boats().keySet().stream().filter(found::containsKey).forEach(boat -> shares.put(boat, found.get(boat)));
        Geometry rest = region.rest(List.copyOf(shares.values()));
        return new Coverage(
                shares,
                noWay,
                region.areaM2(),
                rest.getArea(),
                UncoveredArea.areas(rest, region.plane()),
                unreached,
                beyond);
    }
}
