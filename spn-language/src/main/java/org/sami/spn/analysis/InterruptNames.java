package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/** Two buttons of one name are one button: pressing it concerns both transitions where both have somebody to take. */
final class InterruptNames implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-INTERRUPT-TWICE",
                "The operator sees one button for two interrupts, and the first takes what the other waits " + "for.",
                "Give one of the two another name."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Map<Value, List<PlacedInput>> buttons = new LinkedHashMap<>();
        for (PlacedInput input : plan.inputs()) {
            Value name = input.spec().fields().get(Reserved.INTERRUPT_NAME);
            if (input.type().role() == EventRole.INTERRUPT && name != null) {
                buttons.computeIfAbsent(name, n -> new ArrayList<>()).add(input);
            }
        }
        for (List<PlacedInput> same : buttons.values()) {
            for (PlacedInput later : same.subList(1, same.size())) {
                if (compete(plan, same.get(0), later)) {
                    report.accept(Finding.warning(
                            "W-INTERRUPT-TWICE",
                            later.pointer(),
                            "The " + plan.name(later.transition()) + " has the same interrupt name as the "
                                    + plan.name(same.get(0).transition()) + " and takes from the same place",
                            same.get(0).transition().id(),
                            later.transition().id()));
                }
            }
        }
    }

    private static boolean compete(PlanContext plan, PlacedInput a, PlacedInput b) {
        List<Place> first = plan.inPlaces(a.transition());
        List<Place> second = plan.inPlaces(b.transition());
        return first.isEmpty() || second.isEmpty() || first.stream().anyMatch(second::contains);
    }
}
