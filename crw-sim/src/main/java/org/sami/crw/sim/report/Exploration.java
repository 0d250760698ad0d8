package org.sami.crw.sim.report;

import java.util.List;

/**
 * What became of an area that boats were to explore.
 *
 * @param askedAtMillis time of the run at which it was asked
 * @param spacingM distance between two lanes in metres: a point is covered when a boat came as near as half of it since
 * @param areaM2 square metres to be explored: the area without what was to be avoided
 * @param uncoveredM2 square metres of it that no boat came near
 * @param uncovered that part, without crumbs of less than a square metre
 */
public record Exploration(
        long askedAtMillis, double spacingM, double areaM2, double uncoveredM2, List<MapArea> uncovered) {
    public Exploration {
        uncovered = List.copyOf(uncovered);
    }
}
