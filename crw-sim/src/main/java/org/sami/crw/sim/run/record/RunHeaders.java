package org.sami.crw.sim.run.record;

import java.util.Optional;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.RunHeader;
import org.sami.crw.report.RunPlace;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.vocabulary.Vocabulary;

/** Headers of reports: what was run. */
public final class RunHeaders {
    private static final int HASH_DIGITS = 64;

    private RunHeaders() {}

    /**
     * The header of a run of one plan.
     *
     * @param plane around the area's centre
     */
    public static RunHeader of(RunPlan plan, RunSettings settings, LocalFrame plane) {
        FleetSettings fleet = settings.fleet();
        Optional<GeoPoint> quay = settings.isConnected()
                ? Optional.empty()
                : Optional.of(fleet.site().quayInProcess(fleet.areaM()));
        return new RunHeader(
                plan.plan().id(),
                plan.plan().title(),
                PlanHash.of(plan),
                settings.mission(),
                fleet.seed(),
                settings.speed().toString(),
                fleet.areaM(),
                new RunPlace(centre(plane), quay.map(at -> point(at, plane))),
                HandlerModules.robotsOf(plan.vocabulary()));
    }

    /**
     * The header of a session, in which people started missions.
     *
     * @param plane around the area's centre
     */
    public static RunHeader ofSession(Project project, Vocabulary vocabulary, LocalFrame plane) {
        return new RunHeader(
                project.id(),
                project.name(),
                "0".repeat(HASH_DIGITS),
                "session",
                0,
                "1",
                0,
                new RunPlace(centre(plane), Optional.empty()),
                HandlerModules.robotsOf(vocabulary));
    }

    private static MapPoint centre(LocalFrame plane) {
        return new MapPoint(plane.originLatDeg(), plane.originLonDeg(), 0, 0);
    }

    private static MapPoint point(GeoPoint at, LocalFrame plane) {
        return new MapPoint(
                at.latDeg(),
                at.lonDeg(),
                plane.eastM(at.latDeg(), at.lonDeg()),
                plane.northM(at.latDeg(), at.lonDeg()));
    }
}
