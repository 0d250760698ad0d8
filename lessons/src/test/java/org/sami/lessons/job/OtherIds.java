package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * The same plan as another author would have drawn it: other ids, names and variables, everything in the opposite order but for
 * that in which transitions are looked at, which is meaning; no layout.
 */
final class OtherIds {
    private OtherIds() {}

    static Project of(Project project) {
        return project.withPlans(project.plans().stream().map(OtherIds::of).toList());
    }

    private static String other(String id) {
        return "x-" + id;
    }

    private static String variable(String name) {
        return "@mine" + name.substring(1);
    }

    private static Plan of(Plan plan) {
        return plan.withName("Mine")
                .withLayout(Map.of())
                .withTestCases(List.of())
                .withVariables(plan.variables().stream()
                        .map(variable -> variable.withName(variable(variable.name())))
                        .toList())
                .withPlaces(reversed(plan.places().stream()
                        .map(place -> place.withId(other(place.id()))
                                .withName("Place " + place.id().length())
                                .withTransitionOrder(plan.inEdges().stream()
                                        .filter(edge -> edge.place().equals(place.id()))
                                        .map(edge -> other(edge.transition()))
                                        .toList())
                                .withOutputs(reversed(place.outputs().stream()
                                        .map(OtherIds::of)
                                        .toList())))
                        .toList()))
                .withTransitions(reversed(plan.transitions().stream()
                        .map(transition -> transition
                                .withId(other(transition.id()))
                                .withName("")
                                .withInputs(reversed(transition.inputs().stream()
                                        .map(input -> {
                                            Map<String, String> writes = new LinkedHashMap<>();
                                            input.writes().forEach((field, name) -> writes.put(field, variable(name)));
                                            return input.withId(other(input.id()))
                                                    .withWrites(writes);
                                        })
                                        .toList())))
                        .toList()))
                .withInEdges(reversed(plan.inEdges().stream()
                        .map(edge -> edge.withId(other(edge.id()))
                                .withPlace(other(edge.place()))
                                .withTransition(other(edge.transition()))
                                .withRequirements(reversed(edge.requirements())))
                        .toList()))
                .withOutEdges(reversed(plan.outEdges().stream()
                        .map(edge -> edge.withId(other(edge.id()))
                                .withPlace(other(edge.place()))
                                .withTransition(other(edge.transition()))
                                .withRequirements(reversed(edge.requirements())))
                        .toList()));
    }

    private static OutputEventSpec of(OutputEventSpec output) {
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        output.fields()
                .forEach((field, source) -> fields.put(
                        field,
                        source instanceof FieldSource.FromVariable from
                                ? new FieldSource.FromVariable(variable(from.variable()))
                                : source));
        return output.withId(other(output.id())).withFields(fields);
    }

    private static <T> List<T> reversed(List<T> list) {
        List<T> reversed = new ArrayList<>(list);
        Collections.reverse(reversed);
        return reversed;
    }
}
