package org.sami.crw.sim.run.settings;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.service.Geodesy;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.Value;

/** The places on earth that a plan, those that it runs, and the global variables name: where its water should be. */
public final class PlanLocations {
    private final List<GeoPoint> points = new ArrayList<>();
    private final int ofPlan; // so many of the points are the plan's; those of the project's variables follow

    /**
     * Looks through a plan.
     *
     * @param parameters what it is given at its start
     */
    public PlanLocations(Project project, Plan plan, Collection<Value> parameters) {
        parameters.forEach(this::add);
        add(project, plan, new HashSet<>());
        ofPlan = points.size();
        project.globals().forEach(this::add);
    }

    private void add(Project project, Plan plan, Set<String> seen) {
        if (!seen.add(plan.id())) {
            return;
        }
        plan.variables().forEach(this::add);
        plan.places().stream()
                .flatMap(place -> place.outputs().stream())
                .flatMap(output -> output.fields().values().stream())
                .forEach(this::add);
        plan.places().stream()
                .flatMap(place -> place.subMissions().stream())
                .forEach(child -> project.plan(child.plan()).ifPresent(p -> add(project, p, seen)));
    }

    private void add(VariableSpec variable) {
        variable.initial().ifPresent(this::add);
    }

    private void add(FieldSource source) {
        if (source instanceof FieldSource.Fixed fixed) {
            add(fixed.value());
        } else if (source instanceof FieldSource.Asked asked) {
            asked.defaultValue().ifPresent(this::add);
        }
    }

    private void add(Value value) {
        if (value instanceof GeoPoint point) {
            points.add(point);
        } else if (value instanceof GeoPath path) {
            points.addAll(path.points());
        } else if (value instanceof GeoArea area) {
            points.addAll(area.outline());
        } else if (value instanceof ListValue list) {
            list.items().forEach(this::add);
        } else if (value instanceof MapValue map) {
            map.entries().values().forEach(this::add);
        } else if (value instanceof RecordValue part) {
            part.fields().values().forEach(this::add);
        }
    }

    /** The first place that the plan or its parameters name and that is beyond the water around a centre. */
    public Optional<GeoPoint> beyond(GeoPoint centre) {
        return points.subList(0, ofPlan).stream()
                .filter(point -> Geodesy.distanceM(centre, point) > Site.REACH_M)
                .findFirst();
    }

    /**
     * Where the centre suits the plan. It stays where it is while all places are in the area; else it is in the middle of those
     * that can be reached from the first one: what the plan names comes before what the project's variables hold.
     */
    public GeoPoint suitable(GeoPoint usual, double areaM) {
        if (points.stream().allMatch(p -> Geodesy.distanceM(usual, p) <= areaM / 2)) {
            return usual;
        }
        List<GeoPoint> near = points.stream()
                .filter(p -> Geodesy.distanceM(points.get(0), p) <= Site.REACH_M / 2)
                .toList();
        double latDeg = near.stream().mapToDouble(GeoPoint::latDeg).average().orElseThrow();
        double lonDeg = near.stream().mapToDouble(GeoPoint::lonDeg).average().orElseThrow();
        return GeoPoint.of(latDeg, lonDeg);
    }
}
