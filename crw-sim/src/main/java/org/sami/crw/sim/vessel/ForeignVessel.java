package org.sami.crw.sim.vessel;

import java.util.List;
import java.util.Objects;
import org.sami.crw.sim.hull.Conditions;

/**
 * A vessel or an object on the water that the base does not command.
 *
 * @param name for reports; boats and operators do not know it
 * @param lengthM in metres
 * @param beamM its width in metres
 * @param track where it is at which times, in order; straight and at even speed between them, at rest before and after
 * @param drifts whether it is carried by current and wind from its only place
 */
public record ForeignVessel(String name, double lengthM, double beamM, List<TrackPlace> track, boolean drifts) {
    /** The largest vessel, in metres. */
    static final double LONGEST_M = 40;

    /** The widest vessel, in metres. */
    static final double WIDEST_M = 12;

    private static final double FASTEST_MPS = 20;
    private static final double FARTHEST_M = 20_000;
    private static final double WIND_SHARE = 0.03; // of the wind's speed, at which it carries a hull

    /**
     * A place at a time.
     *
     * @param atS seconds since the start
     * @param eastM metres east of the berth of the first boat
     * @param northM metres north of it
     */
    public record TrackPlace(double atS, double eastM, double northM) {
        public TrackPlace {
            if (!(atS >= 0 && atS <= 1e6 && Math.hypot(eastM, northM) <= FARTHEST_M)) {
                throw new IllegalArgumentException("a place has a time from 0 s on and lies within 20 km, not " + atS
                        + " s at " + eastM + " m east and " + northM + " m north");
            }
        }
    }

    /** Refuses a vessel without a track, or one that no boat could meet. */
    public ForeignVessel {
        Objects.requireNonNull(name, "name");
        track = List.copyOf(track);
        if (name.isBlank() || name.length() > 60) {
            throw new IllegalArgumentException("a name has 1 to 60 characters");
        }
        if (!(lengthM > 0 && lengthM <= LONGEST_M && beamM > 0 && beamM <= WIDEST_M)) {
            throw new IllegalArgumentException(name + " is " + lengthM + " m long and " + beamM
                    + " m wide: vessels are up to 40 m long and 12 m wide");
        }
        if (track.isEmpty() || (drifts && track.size() > 1)) {
            throw new IllegalArgumentException(
                    name + (drifts ? " drifts: it has one place, not a track" : " has no track"));
        }
        for (int i = 1; i < track.size(); i++) {
            TrackPlace from = track.get(i - 1);
            TrackPlace to = track.get(i);
            double metres = Math.hypot(to.eastM() - from.eastM(), to.northM() - from.northM());
            if (!(to.atS() > from.atS() && metres / (to.atS() - from.atS()) <= FASTEST_MPS)) {
                throw new IllegalArgumentException(
                        name + ": times of a track rise, and its speed is at most 20 m/s; look at " + to.atS() + " s");
            }
        }
    }

    /** Where it is and how it moves, so many seconds after the start. */
    VesselState at(double seconds, Conditions water) {
        TrackPlace first = track.get(0);
        if (drifts) {
            double eastMps =
                    water.current().eastMps() - WIND_SHARE * water.wind().eastMps(); // a wind comes from there
            double northMps =
                    water.current().northMps() - WIND_SHARE * water.wind().northMps();
            double sinceS = Math.max(0, seconds - first.atS());
            return state(
                    first.eastM() + eastMps * sinceS,
                    first.northM() + northMps * sinceS,
                    sinceS > 0 ? eastMps : 0,
                    sinceS > 0 ? northMps : 0,
                    StrictMath.atan2(eastMps, northMps));
        }
        int next = 0;
        while (next < track.size() && track.get(next).atS() <= seconds) {
            next++;
        }
        if (next == 0 || next == track.size()) {
            TrackPlace rests = track.get(Math.max(0, next - 1));
            return state(
                    rests.eastM(),
                    rests.northM(),
                    0,
                    0,
                    track.size() < 2 ? 0 : courseRad(Math.max(1, Math.min(next, track.size() - 1))));
        }
        TrackPlace from = track.get(next - 1);
        TrackPlace to = track.get(next);
        double legS = to.atS() - from.atS();
        double eastMps = (to.eastM() - from.eastM()) / legS;
        double northMps = (to.northM() - from.northM()) / legS;
        double sinceS = seconds - from.atS();
        return state(
                from.eastM() + eastMps * sinceS, from.northM() + northMps * sinceS, eastMps, northMps, courseRad(next));
    }

    private double courseRad(int leg) {
        TrackPlace from = track.get(leg - 1);
        TrackPlace to = track.get(leg);
        return StrictMath.atan2(to.eastM() - from.eastM(), to.northM() - from.northM());
    }

    private VesselState state(double eastM, double northM, double eastMps, double northMps, double courseRad) {
        return new VesselState(
                eastM, northM, courseRad, StrictMath.sqrt(eastMps * eastMps + northMps * northMps), lengthM, beamM);
    }
}
