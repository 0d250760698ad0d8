package org.sami.ui.value;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/** Finds on which ways robots would go along paths, for pictures of them. On the event thread. */
@FunctionalInterface
public interface RobotWays {
    /** Paths are drawn as they are. */
    RobotWays AS_GIVEN = (robot, path, found) -> {};

    /**
     * Finds the way of a robot.
     *
     * @param found receives the way from where the robot is, at once or later, and again where it becomes better known; not called where none is known
     */
    void find(String robot, GeoPath path, Consumer<List<GeoPoint>> found);
}
