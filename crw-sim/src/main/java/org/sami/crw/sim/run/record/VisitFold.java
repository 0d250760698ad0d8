package org.sami.crw.sim.run.record;

import java.util.Collection;
import java.util.List;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * The locations that the operator gives, and the reported visits. Locations are the points of lists and paths in answers and in the parameters of a
 * mission. A single point is a place to gather or to return to, not a location to visit.
 */
final class VisitFold implements ReportFold {
    private final VisitRecorder visits = new VisitRecorder();
    private final LocalFrame plane;

    /**
     * A fold.
     *
     * @param plane around the area's centre
     */
    VisitFold(LocalFrame plane) {
        this.plane = plane;
    }

    VisitRecorder visits() {
        return visits;
    }

    @Override
    public void onVisit(String boat, GeoPoint point, long atMillis) {
        visits.visited(point.latDeg(), point.lonDeg(), atMillis, boat);
    }

    @Override
    public void addTo(ReportDraft report) {
        report.locations(visits.locations());
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (input instanceof Input.StartMission start) {
            add(start.parameters().values());
        }
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionClosed closed
                    && closed.answer().orElse(null) instanceof Answer.Fields fields) {
                add(fields.values().values());
            }
        }
    }

    private void add(Collection<Value> values) {
        for (Value value : values) {
            if (value instanceof ListValue list) {
                list.items().forEach(this::add);
            } else if (value instanceof GeoPath path) {
                path.points().forEach(this::add);
            }
        }
    }

    private void add(Value item) {
        if (item instanceof GeoPoint point) {
            visits.add(
                    point.latDeg(),
                    point.lonDeg(),
                    plane.eastM(point.latDeg(), point.lonDeg()),
                    plane.northM(point.latDeg(), point.lonDeg()));
        }
    }
}
