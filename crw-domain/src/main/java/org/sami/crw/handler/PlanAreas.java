package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** The areas that a plan keeps its boats out of: what its requests for ways and places name as {@code avoid}, as it stands now. */
final class PlanAreas {
    private PlanAreas() {}

    /** Those of the activation itself, of its plan, and of the plans that run it as a sub-mission; each once. */
    static List<GeoArea> avoided(Activation activation, EngineView view) {
        Set<GeoArea> areas = new LinkedHashSet<>(Restrictions.avoid(activation));
        Optional<MissionView> mission = view.mission(activation.mission());
        while (mission.isPresent()) {
            MissionView one = mission.get();
            view.planOf(one.id()).ifPresent(plan -> plan.places().forEach(place -> add(place, one, view, areas)));
            mission = view.mission(one.parent());
        }
        return List.copyOf(areas);
    }

    private static void add(Place place, MissionView mission, EngineView view, Set<GeoArea> areas) {
        for (OutputEventSpec output : place.outputs()) {
            FieldSource source = output.fields().get(Restrictions.AVOID);
            Optional<Value> value = Optional.empty();
            if (source instanceof FieldSource.Fixed fixed) {
                value = Optional.of(fixed.value());
            } else if (source instanceof FieldSource.FromVariable read) {
                value = view.variable(mission.id(), read.variable());
            }
            areas.addAll(areas(value));
        }
    }

    private static List<GeoArea> areas(Optional<Value> value) {
        List<GeoArea> areas = new ArrayList<>();
        value.filter(ListValue.class::isInstance)
                .ifPresent(list -> ((ListValue) list).items().forEach(item -> {
                    if (item instanceof GeoArea area) {
                        areas.add(area);
                    }
                }));
        return areas;
    }
}
