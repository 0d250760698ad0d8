package org.sami.spn.wizard;

import java.util.Optional;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;

/** Finds room in a drawing for new vertices, left to right as plans are drawn. */
final class FreeSpace {
    /** Between a vertex and the next, in drawing units. */
    private static final double STEP = 120;

    /** Nearer than this two vertices touch each other's names. */
    private static final double CLEARANCE = 90;

    private static final int ROWS = 40;

    private FreeSpace() {}

    /** A free point to the right of a vertex: level with it, else lower or higher; empty where the vertex has no point itself. */
    static Optional<LayoutPoint> behind(Plan plan, String vertex) {
        return Optional.ofNullable(plan.layout().get(vertex)).map(from -> {
            for (int row = 0; row < ROWS; row++) {
                int down = row % 2 == 0 ? -row / 2 : (row + 1) / 2; // 0, 1, -1, 2, -2, …
                LayoutPoint at = new LayoutPoint(from.x() + STEP, from.y() + down * STEP);
                if (plan.layout().values().stream().allMatch(p -> apart(p, at))) {
                    return at;
                }
            }
            return new LayoutPoint(from.x() + STEP, from.y() + ROWS * STEP);
        });
    }

    private static boolean apart(LayoutPoint a, LayoutPoint b) {
        return Math.abs(a.x() - b.x()) >= CLEARANCE || Math.abs(a.y() - b.y()) >= CLEARANCE;
    }
}
