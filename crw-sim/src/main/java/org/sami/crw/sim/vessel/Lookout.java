package org.sami.crw.sim.vessel;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleSupplier;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LookoutReadings;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.VesselInSight;
import org.sami.crw.sim.hull.Conditions;

/**
 * What one simulated boat sees of foreign vessels: those within its sight, exactly. It reports them to its base in turn, as the readings of an instrument, and
 * gives them to its server, which gives way to them. For the boat's thread.
 */
public final class Lookout implements Sensor {
    private static final long PERIOD_MS = 500;

    private final ForeignVessels vessels;
    private final Conditions water;
    private final LocalFrame plane;
    private final DoubleSupplier eastM;
    private final DoubleSupplier northM;
    private final DoubleSupplier seconds;
    private int reported;

    /**
     * The lookout of a boat.
     *
     * @param plane on which the vessels' places are, with the first boat's berth as its origin
     * @param eastM where the boat is on it
     * @param northM where the boat is on it
     * @param seconds since the start
     */
    public Lookout(
            ForeignVessels vessels,
            Conditions water,
            LocalFrame plane,
            DoubleSupplier eastM,
            DoubleSupplier northM,
            DoubleSupplier seconds) {
        this.vessels = vessels;
        this.water = water;
        this.plane = plane;
        this.eastM = eastM;
        this.northM = northM;
        this.seconds = seconds;
    }

    /** The vessels in sight. Nobody of the base commands them: they have the right of way. */
    public List<VesselInSight> inSight() {
        List<VesselInSight> seen = new ArrayList<>();
        List<VesselState> states = vessels.at(seconds.getAsDouble(), water);
        for (int i = 0; i < states.size(); i++) {
            VesselState state = states.get(i);
            if (sees(state)) {
                NearbyBoat middle = new NearbyBoat(
                        "vessel " + (i + 1),
                        plane.latDeg(state.eastM(), state.northM()),
                        plane.lonDeg(state.eastM(), state.northM()),
                        state.courseRad(),
                        state.speedMps(),
                        BoatMode.TELEOPERATION,
                        0);
                seen.add(new VesselInSight(middle, state.radiusM()));
            }
        }
        return seen;
    }

    private boolean sees(VesselState state) {
        return state.distanceM(eastM.getAsDouble(), northM.getAsDouble()) <= vessels.sightM();
    }

    @Override
    public String name() {
        return LookoutReadings.SENSOR;
    }

    @Override
    public String channel() {
        return LookoutReadings.VESSEL;
    }

    @Override
    public String unit() {
        return "";
    }

    @Override
    public long periodMs() {
        return PERIOD_MS;
    }

    /** The next vessel in sight. */
    @Override
    public List<Double> read() {
        List<VesselState> states = vessels.at(seconds.getAsDouble(), water);
        for (int i = 0; i < states.size(); i++) {
            int next = (reported + 1 + i) % states.size();
            VesselState state = states.get(next);
            if (sees(state)) {
                reported = next;
                return List.of(
                        (double) (next + 1),
                        plane.latDeg(state.eastM(), state.northM()),
                        plane.lonDeg(state.eastM(), state.northM()),
                        Math.toDegrees(state.courseRad()),
                        state.speedMps(),
                        state.lengthM(),
                        state.beamM());
            }
        }
        return Collections.emptyList();
    }
}
