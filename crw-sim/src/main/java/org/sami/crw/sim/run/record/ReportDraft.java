package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.crw.operator.mission.Wait;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.DecisionResult;
import org.sami.crw.report.FiringResult;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.ReadingResult;
import org.sami.crw.report.ReportPart;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunMap;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.RunResult;
import org.sami.crw.report.TaskResult;

/** A report while its folds add their parts. A part that no fold adds is empty. For one thread. */
public final class ReportDraft {
    private static final int HASH_DIGITS = 64;

    private final ReportEnd end;
    private final List<NoteResult> notes = new ArrayList<>();
    private long clicks;
    private String hash = "0".repeat(HASH_DIGITS);
    private List<FiringResult> firings = List.of();
    private List<DecisionResult> decisions = List.of();
    private List<LocationResult> locations = List.of();
    private List<InterruptResult> interrupts = List.of();
    private List<ReadingResult> readings = List.of();
    private List<TaskResult> tasks = List.of();
    private List<Wait> waits = List.of();
    private final List<ReportPart> parts = new ArrayList<>();
    private KnownTracks tracks = KnownTracks.reported(List.of());
    private OptionalDouble announcedM = OptionalDouble.empty();
    private Optional<RunMap> map = Optional.empty();

    ReportDraft(ReportEnd end) {
        this.end = end;
    }

    /** The state of the run at its end. */
    ReportEnd end() {
        return end;
    }

    /** Adds notes; notes of the same moment keep the order of the folds. */
    public void note(List<NoteResult> more) {
        notes.addAll(more);
    }

    void clicks(long count) {
        clicks = count;
    }

    void hash(String of) {
        hash = of;
    }

    void firings(List<FiringResult> all) {
        firings = all;
    }

    void decisions(List<DecisionResult> all) {
        decisions = all;
    }

    void locations(List<LocationResult> all) {
        locations = all;
    }

    List<LocationResult> locations() {
        return locations;
    }

    /** Depth to which boats might enter avoided areas at most, as announced to the operator, in metres. */
    void announcedM(OptionalDouble mostM) {
        announcedM = mostM;
    }

    OptionalDouble announcedM() {
        return announcedM;
    }

    /** The results of the run's interrupts. */
    public void interrupts(List<InterruptResult> all) {
        interrupts = all;
    }

    void readings(List<ReadingResult> all) {
        readings = all;
    }

    void tasks(List<TaskResult> all) {
        tasks = all;
    }

    /** The state of the mission and what it waits for. */
    public void waits(List<Wait> all) {
        waits = all;
    }

    /** Adds a further part; the report keeps the order in which parts are added. */
    public void add(ReportPart part) {
        parts.add(part);
    }

    void tracks(KnownTracks known) {
        tracks = known;
    }

    KnownTracks tracks() {
        return tracks;
    }

    void map(RunMap of) {
        map = Optional.of(of);
    }

    /** The report of the parts so far. */
    RunReport report(RunHeader header) {
        List<BoatResult> boats = tracks.best();
        notes.sort(Comparator.comparingLong(NoteResult::atMillis)); // stable
        return new RunReport(
                header,
                new RunResult(
                        end.outcome(),
                        end.reason(),
                        end.atMillis(),
                        end.wallSeconds(),
                        (int) clicks,
                        firings.size(),
                        end.resumedFrom(),
                        hash),
                boats,
                locations,
                decisions,
                firings,
                interrupts,
                notes,
                readings,
                tasks,
                waits,
                Optional.empty(),
                map.orElseGet(() -> RunMap.of(boats)),
                parts);
    }
}
