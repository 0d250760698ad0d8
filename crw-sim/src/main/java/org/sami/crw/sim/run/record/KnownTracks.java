package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.report.BoatResult;

/**
 * The tracks of a run's boats: as reported and, for simulated boats, true.
 *
 * @param truly empty where nobody knows, as behind TCP
 */
record KnownTracks(List<BoatResult> reported, Optional<List<BoatResult>> truly) {
    KnownTracks {
        reported = List.copyOf(reported);
        Objects.requireNonNull(truly, "truly");
    }

    /** Tracks of boats whose reports are all that is known. */
    static KnownTracks reported(List<BoatResult> boats) {
        return new KnownTracks(boats, Optional.empty());
    }

    /** The true tracks where they are known, otherwise the reported ones. */
    List<BoatResult> best() {
        return truly.orElse(reported);
    }
}
