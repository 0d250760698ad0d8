package org.sami.crw.service.coverage;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.path.PathAnswer;
import org.sami.spn.value.GeoPoint;

/** Finds out which part of an area each boat can get to. */
final class BoatsOfParts {
    private BoatsOfParts() {}

    /**
     * The part of each boat that has one. No way leads from part to part, so a boat has one at most; one whose position is not known goes
     * where there is most to do for each boat.
     *
     * @param noWay gets the boats that can get to no part, and why
     */
    static Map<String, CoveragePart> of(CoverageProblem problem, List<CoveragePart> parts, Map<String, String> noWay) {
        Map<String, CoveragePart> partOf = new LinkedHashMap<>();
        for (Map.Entry<String, Optional<GeoPoint>> boat : problem.boats().entrySet()) {
            boat.getValue().ifPresent(at -> {
                Optional<CoveragePart> part =
                        parts.stream().filter(one -> one.isReachedFrom(at)).findFirst();
                part.ifPresent(one -> partOf.put(boat.getKey(), one));
                if (part.isEmpty() && parts.get(0).way(at) instanceof PathAnswer.NoWay none) {
                    noWay.put(boat.getKey(), none.reason());
                }
            });
        }
        problem.boats().forEach((boat, position) -> {
            if (position.isEmpty()) {
                partOf.put(
                        boat,
                        parts.stream()
                                .max(Comparator.comparingDouble(part -> part.areaM2()
                                        / (1
                                                + partOf.values().stream()
                                                        .filter(part::equals)
                                                        .count())))
                                .orElseThrow());
            }
        });
        return partOf;
    }
}
