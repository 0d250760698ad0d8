package org.sami.crw.sim.boat;

import java.util.function.LongSupplier;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.SimulatedHull;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.crw.sim.vessel.Lookout;

/**
 * The foreign vessels on the water of simulated boats in real time.
 *
 * @param origin of their places: the berth of the first boat
 * @param startMs when their tracks begin, on the clock of the boats
 */
record VesselsAround(ForeignVessels vessels, Conditions water, LocalFrame origin, long startMs) {

    /** The lookout of a boat; it asks the clock itself, on the boat's thread. */
    Lookout of(SimulatedHull hull, LongSupplier clock) {
        return new Lookout(
                vessels,
                water,
                origin,
                () -> origin.eastM(hull.latDeg(), hull.lonDeg()),
                () -> origin.northM(hull.latDeg(), hull.lonDeg()),
                () -> (clock.getAsLong() - startMs) / 1000.0);
    }
}
