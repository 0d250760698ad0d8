package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.InterruptResult;
import org.sami.crw.sim.report.LocationResult;
import org.sami.crw.sim.report.MapPoint;
import org.sami.crw.sim.report.NoteResult;
import org.sami.crw.sim.report.RunHeader;
import org.sami.crw.sim.report.RunMap;
import org.sami.crw.sim.report.RunOutcome;
import org.sami.crw.sim.report.RunPlace;
import org.sami.crw.sim.report.RunReport;
import org.sami.crw.sim.report.RunResult;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.value.GeoPoint;

/** Puts the report of a run together. */
public final class ReportBuilder {
    private final RunPlan plan;
    private final RunSettings settings;
    private final RunRecorder recorder;
    private final OptionalLong resumedFrom;
    private final LocalFrame plane;

    /**
     * For one run.
     *
     * @param resumedFrom index of the last input that was taken from a journal
     * @param plane around the area's centre
     */
    public ReportBuilder(
            RunPlan plan, RunSettings settings, RunRecorder recorder, OptionalLong resumedFrom, LocalFrame plane) {
        this.plan = plan;
        this.settings = settings;
        this.recorder = recorder;
        this.resumedFrom = resumedFrom;
        this.plane = plane;
    }

    /**
     * How and when it came to its end.
     *
     * @param reason one sentence where the outcome needs one, else empty
     */
    public record End(RunOutcome outcome, String reason, long atMillis, double wallSeconds) {}

    /**
     * The report.
     *
     * @param clicks that the operator made
     * @param boats as they are at the end
     * @param messages what the operator was told, oldest first
     * @param map the areas and points of the plan, and how near boats came to one another
     */
    public RunReport build(
            End end,
            long clicks,
            List<BoatState> boats,
            List<BoatResult> results,
            List<LocationResult> locations,
            List<InterruptResult> interrupts,
            List<NoteResult> messages,
            RunMap map) {
        return new RunReport(
                        new RunHeader(
                                plan.plan().id(),
                                plan.plan().title(),
                                PlanHash.of(plan),
                                settings.mission(),
                                settings.fleet().seed(),
                                settings.speed().toString(),
                                settings.fleet().areaM(),
                                place()),
                        new RunResult(
                                end.outcome(),
                                end.reason(),
                                end.atMillis(),
                                end.wallSeconds(),
                                (int) clicks,
                                recorder.firingCount(),
                                resumedFrom,
                                recorder.hash().with(boats)),
                        results,
                        locations,
                        recorder.decisions(),
                        recorder.firings(),
                        interrupts,
                        notes(messages),
                        map)
                .withTasks(recorder.tasks());
    }

    private RunPlace place() {
        RunSettings.Fleet fleet = settings.fleet();
        Optional<GeoPoint> quay = settings.isConnected()
                ? Optional.empty()
                : Optional.of(fleet.site().quayInProcess(fleet.areaM()));
        MapPoint centre = new MapPoint(plane.originLatDeg(), plane.originLonDeg(), 0, 0);
        return new RunPlace(centre, quay.map(this::point));
    }

    private MapPoint point(GeoPoint at) {
        return new MapPoint(
                at.latDeg(),
                at.lonDeg(),
                plane.eastM(at.latDeg(), at.lonDeg()),
                plane.northM(at.latDeg(), at.lonDeg()));
    }

    private List<NoteResult> notes(List<NoteResult> messages) {
        List<NoteResult> notes = new ArrayList<>(recorder.notes());
        notes.addAll(messages);
        notes.sort(Comparator.comparingLong(NoteResult::atMillis)); // stable: of one moment in order of arrival
        return notes;
    }
}
