package org.sami.crw.service.coverage;

import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.service.path.PathAnswer;

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
        problem.boats()
                .forEach((boat, position) -> position.ifPresent(at -> {
                    Optional<CoveragePart> reached = parts.stream()
                            .filter(part -> part.isReachedFrom(at))
                            .findFirst();
                    reached.ifPresent(part -> partOf.put(boat, part));
                    if (reached.isEmpty() && parts.get(0).way(at) instanceof PathAnswer.NoWay none) {
                        noWay.put(boat, none.reason());
                    }
                }));
        problem.boats().forEach((boat, position) -> {
            if (position.isEmpty()) {
                partOf.put(boat, mostForOneMore(parts, partOf.values()));
            }
        });
        return partOf;
    }

    /** The part that leaves the largest area to each of its boats when it gets one more. */
    private static CoveragePart mostForOneMore(List<CoveragePart> parts, Collection<CoveragePart> given) {
        return parts.stream()
                .max(Comparator.comparingDouble(part -> part.areaM2() / (1 + Collections.frequency(given, part))))
                .orElseThrow();
    }
}
