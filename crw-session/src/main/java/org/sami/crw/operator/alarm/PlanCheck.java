package org.sami.crw.operator.alarm;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.value.Value;

/**
 * Which boats of a fleet cannot do what a plan asks of boats. Values that are known only during the mission are left out.
 *
 * @param missing a sentence without its full stop for each boat and each thing that it cannot do
 */
public record PlanCheck(List<String> missing) {
    public PlanCheck {
        missing = List.copyOf(missing);
    }

    /** Goes through all output events of a plan for all boats. */
    public static PlanCheck of(Plan plan, Collection<BoatSnapshot> boats) {
        Set<String> missing = new LinkedHashSet<>();
        plan.places().stream()
                .flatMap(place -> place.outputs().stream())
                .forEach(event -> boats.forEach(
                        boat -> BoatDemands.missing(boat.boat(), capabilities(boat), event.type(), fixed(event))
                                .ifPresent(missing::add)));
        return new PlanCheck(List.copyOf(missing));
    }

    private static BoatCapabilities capabilities(BoatSnapshot boat) {
        return boat.settings().map(BoatTuning::capabilities).orElse(BoatCapabilities.UNKNOWN);
    }

    private static Map<String, Value> fixed(OutputEventSpec event) {
        return event.fields().entrySet().stream()
                .filter(field -> field.getValue() instanceof FieldSource.Fixed)
                .collect(Collectors.toMap(Map.Entry::getKey, field -> ((FieldSource.Fixed) field.getValue()).value()));
    }
}
