package org.sami.crw.handler.activation;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.crw.area.AvoidedAreas;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * The areas in which a plan keeps its boats: what its requests for ways and places name as {@code avoid} and {@code within}, as it stands
 * now. Holes of an area that is explored are avoided too.
 */
public final class PlanAreas {
    private static final String AREA = "area";

    private PlanAreas() {}

    /** What is avoided by the activation itself, by its plan, by the plans that run it as a sub-mission, and by the project; each area once. */
    public static List<GeoArea> avoided(Activation activation, EngineView view) {
        return avoided(Restrictions.avoid(activation), holes(activation.value(AREA)), activation.mission(), view);
    }

    /** What is avoided by a mission's plan, by the plans that run it as a sub-mission, and by the project; each area once. */
    public static List<GeoArea> avoided(long mission, EngineView view) {
        return avoided(List.of(), List.of(), mission, view);
    }

    private static List<GeoArea> avoided(List<GeoArea> own, List<GeoArea> ownHoles, long mission, EngineView view) {
        Set<GeoArea> areas = new LinkedHashSet<>(own);
        areas.addAll(AvoidedAreas.of(mission, view));
        areas.addAll(areas(view.globals().get(OperatingArea.NO_GO)));
        areas.addAll(ownHoles);
        forEachField(mission, view, AREA, value -> areas.addAll(holes(Optional.of(value))));
        return List.copyOf(areas);
    }

    /** The area to stay in: that of the activation, otherwise that of the plans, if they name exactly one. */
    public static Optional<GeoArea> within(Activation activation, EngineView view) {
        Optional<GeoArea> own = Restrictions.within(activation);
        return own.isPresent() ? own : within(activation.mission(), view);
    }

    /** The area that a mission's plans name as the one to stay in, where they name one and not several. */
    public static Optional<GeoArea> within(long mission, EngineView view) {
        Set<GeoArea> areas = new LinkedHashSet<>();
        forEachField(mission, view, Restrictions.WITHIN, value -> areas.addAll(areas(value)));
        return areas.size() == 1 ? areas.stream().findFirst() : Optional.empty();
    }

    /**
     * The water of both, on a plane that touches at a point near by. What lies outside of the area to stay in, as a quay mostly does, is not kept in
     * by what other requests of the plan say.
     */
    public static Water water(Activation activation, EngineView view, GeoPoint near, CrossTrackError error) {
        Optional<GeoArea> within = within(activation, view);
        boolean isKept = Restrictions.within(activation).isPresent()
                || Water.of(near, List.of(), within).allows(List.of(near));
        return Water.of(near, avoided(activation, view), isKept ? within : Optional.empty())
                .drivenWith(error);
    }

    private static void forEachField(long id, EngineView view, String field, Consumer<Value> action) {
        Optional<MissionView> mission = view.mission(id);
        while (mission.isPresent()) {
            MissionView one = mission.get();
            view.planOf(one.id()).stream()
                    .flatMap(plan -> plan.places().stream())
                    .flatMap(place -> place.outputs().stream())
                    .forEach(request -> value(request, field, one, view).ifPresent(action));
            mission = view.mission(one.parent());
        }
    }

    private static Optional<Value> value(OutputEventSpec request, String field, MissionView mission, EngineView view) {
        FieldSource source = request.fields().get(field);
        if (source instanceof FieldSource.Fixed fixed) {
            return Optional.of(fixed.value());
        } else if (source instanceof FieldSource.FromVariable read) {
            return view.variable(mission.id(), read.variable());
        }
        return source instanceof FieldSource.Asked
                ? view.parameter(mission.id(), request.id() + "." + field)
                : Optional.empty();
    }

    private static List<GeoArea> areas(@Nullable Value value) {
        List<GeoArea> areas = new ArrayList<>();
        if (value instanceof GeoArea area) {
            areas.add(area);
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> areas.addAll(areas(item)));
        }
        return areas;
    }

    private static List<GeoArea> holes(Optional<Value> area) {
        return area.map(PlanAreas::areas).orElse(List.of()).stream()
                .flatMap(one -> one.holes().stream())
                .map(hole -> new GeoArea(hole, List.of()))
                .toList();
    }
}
