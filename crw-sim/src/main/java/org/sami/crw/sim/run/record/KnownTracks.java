package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.report.BoatResult;

/**
 * Where boats were in a run: by what they reported and, of simulated ones, truly.
 *
 * @param truly empty where nobody knows, as behind TCP
 */
record KnownTracks(List<BoatResult> reported, Optional<List<BoatResult>> truly) {
    KnownTracks {
        reported = List.copyOf(reported);
        Objects.requireNonNull(truly, "truly");
    }

    /** Tracks of boats of which only that is known what they say. */
    static KnownTracks reported(List<BoatResult> boats) {
        return new KnownTracks(boats, Optional.empty());
    }

    /** The best that is known. */
    List<BoatResult> best() {
        return truly.orElse(reported);
    }
}
