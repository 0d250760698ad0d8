package org.sami.boat.server.vehicle;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.link.BoardCondition;

/**
 * A hull with a motor on each side, as the boat server sees it: the phone's own, or a simulated one.
 *
 * <p>It is asked and set on the thread that ticks the server.
 */
public interface Vehicle extends Kinematics {

    /** Charge of the battery in percent of full. */
    double batteryPercent();

    /** The instruments on board; asked for once. */
    default List<Sensor> sensors() {
        return Collections.emptyList();
    }

    /** The camera on board, if there is one. */
    default Optional<Camera> camera() {
        return Optional.empty();
    }

    /** How its control board is; empty for a vehicle without one. */
    default Optional<BoardCondition> board() {
        return Optional.empty();
    }

    /** Metres above the place of the take-off; empty for what does not fly. */
    default OptionalDouble altM() {
        return OptionalDouble.empty();
    }

    /** Climbs or descends to an altitude in metres and stays there; 0 lands. Nothing happens on what does not fly. */
    default void setAltitude(double altM) {}

    /** Whether it is at the altitude that was set; always so for what does not fly. */
    default boolean isAtAltitude() {
        return true;
    }

    /** Why there is no camera now, in words for people. */
    default String cameraTrouble() {
        return "there is no camera on board";
    }

    /** Vessels that a lookout on board sees and that are not of its base; their ages are 0. Empty for a vehicle without a lookout. */
    default List<VesselInSight> vesselsInSight() {
        return Collections.emptyList();
    }

    /** Sets the efforts of the port and the starboard motor, -1 (full astern) to 1 (full ahead), until set again. */
    void setMotors(double port, double starboard);
}
