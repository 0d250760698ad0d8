package org.sami.crw.sim.fleet;

import java.util.SplittableRandom;

/** The seeds of one boat's parts. */
record BoatSeeds(long hull, long toBoat, long toBase) {
    private static final long INSTRUMENTS = 0x67707320L;

    /** Drawn apart, so that boats with exact instruments are as they always were. */
    long instruments() {
        return hull ^ INSTRUMENTS;
    }

    /** The next boat's seeds out of the fleet's. */
    static BoatSeeds next(SplittableRandom fleet) {
        return new BoatSeeds(fleet.nextLong(), fleet.nextLong(), fleet.nextLong());
    }
}
