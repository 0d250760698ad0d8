package org.sami.crw.sim.run.record;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.crw.report.BoatResult;

/**
 * The true tracks of simulated boats. Their reports differ where positions are not exact, and are recorded while boats explore: coverage is judged by
 * both.
 */
public final class TrueTracks implements ReportFold {
    private final TrackRecorder reported = new TrackRecorder();
    private final Optional<Supplier<List<BoatState>>> reporting;

    /**
     * A fold for the list that has the boats' tracks.
     *
     * @param reporting gives the boats where they say that they are; empty where positions are exact
     */
    public TrueTracks(Optional<Supplier<List<BoatState>>> reporting) {
        this.reporting = reporting;
    }

    /** Records the reported positions; called once a second while there is something to explore. */
    public void look(long nowMillis) {
        reporting.ifPresent(boats -> reported.look(nowMillis, boats.get()));
    }

    @Override
    public void addTo(ReportDraft report) {
        List<BoatResult> truly = report.tracks().best();
        ReportEnd end = report.end();
        List<BoatResult> said = reporting
                .map(boats -> reported.results(end.atMillis(), boats.get(), end.links()))
                .orElse(truly);
        report.tracks(new KnownTracks(said, Optional.of(truly)));
    }
}
