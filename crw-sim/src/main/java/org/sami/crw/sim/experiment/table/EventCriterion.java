package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Project;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.Value;

/**
 * What one output event is to be optimised for in a version: its Optimize markup, all others of the event as they were.
 *
 * @param plan id of the plan
 * @param event id of its output event
 * @param criterion constant of the vocabulary, such as {@code EXECUTION_TIME}
 */
record EventCriterion(String plan, String event, String criterion) {
    private static final String MARKUP = "Optimize";
    private static final String OPTION = "criteria";
    private static final String TYPE = "Criterion";

    EventCriterion {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(criterion, "criterion");
    }

    /** The project with these criteria. */
    static Project inAll(Project project, List<EventCriterion> criteria) {
        Project changed = project;
        for (EventCriterion one : criteria) {
            changed = OutputEvents.changed(
                    changed,
                    (plan, output) ->
                            plan.id().equals(one.plan) && output.id().equals(one.event) ? one.on(output) : output);
        }
        return changed;
    }

    private OutputEventSpec on(OutputEventSpec output) {
        List<MarkupSpec> markups = new ArrayList<>(output.markups());
        markups.removeIf(markup -> markup.type().equals(MARKUP));
        Map<String, Value> options = new LinkedHashMap<>();
        options.put(OPTION, new EnumValue(TYPE, criterion));
        markups.add(new MarkupSpec(MARKUP, options));
        return output.withMarkups(markups);
    }

    /** Whether a project has the event. */
    static boolean hasEvent(Project project, String plan, String event) {
        return project.plan(plan)
                .filter(known -> known.places().stream()
                        .anyMatch(place -> place.outputs().stream()
                                .anyMatch(output -> output.id().equals(event))))
                .isPresent();
    }
}
