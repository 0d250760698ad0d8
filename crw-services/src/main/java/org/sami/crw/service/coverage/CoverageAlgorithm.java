package org.sami.crw.service.coverage;

/** Finds tracks that cover an area. Deterministic; no state. */
@FunctionalInterface
public interface CoverageAlgorithm {
    /**
     * Tracks for the boats of a problem.
     *
     * @throws IllegalArgumentException for an area that is no simple polygon, or of which nothing may be entered
     */
    Coverage cover(CoverageProblem problem);
}
