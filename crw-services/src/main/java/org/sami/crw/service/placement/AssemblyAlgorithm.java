package org.sami.crw.service.placement;

import java.util.Map;
import org.sami.spn.value.GeoPoint;

/** Gives each boat a location of its own near a point (appendix .2.1, Assemble Location Request). Deterministic. */
@FunctionalInterface
public interface AssemblyAlgorithm {
    /** A location for each boat, in the boats' order; no two nearer to each other than the spacing. */
    Map<String, GeoPoint> assemble(AssemblyProblem problem);
}
