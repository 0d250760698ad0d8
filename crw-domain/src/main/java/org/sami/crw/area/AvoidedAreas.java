package org.sami.crw.area;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * The areas that missions avoid: the {@code avoid} areas in the requests of their plans, and of the plans that run them, at present. For the engine's
 * thread.
 */
public final class AvoidedAreas {
    private static final String AVOID = "avoid";

    /** Of running missions whose plans have such requests, also where they name no area now. */
    private final Map<Long, List<GeoArea>> known = new LinkedHashMap<>();

    /** The areas of one mission, each once; none where it is not running. */
    public static List<GeoArea> of(long mission, EngineView view) {
        return find(mission, view).orElse(List.of());
    }

    /** Empty where no plan has such a request. */
    private static Optional<List<GeoArea>> find(long mission, EngineView view) {
        Set<GeoArea> areas = new LinkedHashSet<>();
        boolean asks = false;
        for (Optional<MissionView> m = view.mission(mission);
                m.isPresent();
                m = view.mission(m.get().parent())) {
            long id = m.get().id();
            for (OutputEventSpec request : requests(view.planOf(id))) {
                asks = true;
                areas.addAll(OperatingArea.areas(value(request, id, view)));
            }
        }
        return asks ? Optional.of(new ArrayList<>(areas)) : Optional.empty();
    }

    private static List<OutputEventSpec> requests(Optional<Plan> plan) {
        return plan.stream()
                .flatMap(one -> one.places().stream())
                .flatMap(place -> place.outputs().stream())
                .filter(output -> output.fields().containsKey(AVOID))
                .toList();
    }

    private static Optional<Value> value(OutputEventSpec request, long mission, EngineView view) {
        FieldSource source = request.fields().get(AVOID);
        if (source instanceof FieldSource.Fixed fixed) {
            return Optional.of(fixed.value());
        } else if (source instanceof FieldSource.FromVariable read) {
            return view.variable(mission, read.variable());
        }
        return source instanceof FieldSource.Asked
                ? view.parameter(mission, request.id() + "." + AVOID)
                : Optional.empty();
    }

    /** The areas of all missions that have some, where a step has changed them. */
    public Optional<Map<Long, List<GeoArea>>> after(List<Effect> effects, EngineView view) {
        Map<Long, List<GeoArea>> before = some();
        boolean ask = false;
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started) {
                find(started.mission(), view).ifPresent(areas -> known.put(started.mission(), areas));
            } else if (effect instanceof Effect.MissionEnded ended && ended.outcome() != Outcome.HALTED) {
                known.remove(ended.mission());
            } else if (effect instanceof Effect.VariableWritten written) {
                ask |= written.value() instanceof ListValue;
            } else if (effect instanceof Effect.Activated sent) { // what is asked at the start is known by now
                ask |= sent.activation().values().containsKey(AVOID);
            }
        }
        if (ask) {
            known.replaceAll((mission, areas) -> of(mission, view));
        }
        Map<Long, List<GeoArea>> now = some();
        return now.equals(before) ? Optional.empty() : Optional.of(now);
    }

    /** Takes up the missions of a state; gives the areas of all that have some. */
    public Map<Long, List<GeoArea>> restore(EngineView view) {
        known.clear();
        view.missions().forEach(mission -> find(mission.id(), view).ifPresent(areas -> known.put(mission.id(), areas)));
        return some();
    }

    private Map<Long, List<GeoArea>> some() {
        Map<Long, List<GeoArea>> some = new LinkedHashMap<>(known);
        some.values().removeIf(List::isEmpty);
        return some;
    }
}
