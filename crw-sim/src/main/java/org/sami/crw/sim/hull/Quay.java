package org.sami.crw.sim.hull;

/**
 * A quay of the simulated world: a line from west to east and the water near it. There people swap batteries: a boat that has
 * driven, or was commanded to, and comes to rest for {@link #SWAP_SECONDS} gets a full one. A boat that was only launched there keeps the
 * battery that it has.
 *
 * @param westM western end, in metres east of the world's origin
 * @param eastM eastern end, likewise
 * @param northM metres north of the origin
 * @param reachM how far from the line a boat still lies at the quay, in metres
 */
public record Quay(double westM, double eastM, double northM, double reachM) {
    /** How long a boat lies still until its battery is full, in seconds. */
    public static final double SWAP_SECONDS = 10;

    /** How near a boat comes to be looked after, in metres, unless a world wants it otherwise. */
    public static final double REACH_M = 18;

    public Quay {
        if (!(westM <= eastM && reachM > 0)) {
            throw new IllegalArgumentException("a quay from " + westM + " to " + eastM + ", reach " + reachM);
        }
    }

    /** The quay of a boat that lies alone at the origin. */
    public static Quay atOrigin() {
        return new Quay(0, 0, 0, REACH_M);
    }

    /** Whether a place is near enough. */
    boolean reaches(double placeEastM, double placeNorthM) {
        double alongM = Math.max(westM, Math.min(eastM, placeEastM));
        double eastward = placeEastM - alongM;
        double northward = placeNorthM - northM;
        return eastward * eastward + northward * northward <= reachM * reachM;
    }
}
