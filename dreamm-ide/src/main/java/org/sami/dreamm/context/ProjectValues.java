package org.sami.dreamm.context;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.Value;

/** The values that a project holds: first values of its variables, then those of its plans and of fields of their events. */
final class ProjectValues {
    private ProjectValues() {}

    static List<Value> of(Project project) {
        List<Value> values = new ArrayList<>(ofVariables(project));
        for (Plan plan : project.plans()) {
            plan.places().forEach(p -> p.outputs().forEach(o -> addFields(o, values)));
        }
        return values;
    }

    static List<Value> ofVariables(Project project) {
        List<Value> values = new ArrayList<>();
        project.globals().forEach(v -> v.initial().ifPresent(values::add));
        project.plans().forEach(p -> p.variables().forEach(v -> v.initial().ifPresent(values::add)));
        return values;
    }

    private static void addFields(OutputEventSpec output, List<Value> values) {
        for (FieldSource source : output.fields().values()) {
            if (source instanceof FieldSource.Fixed fixed) {
                values.add(fixed.value());
            } else if (source instanceof FieldSource.Asked asked) {
                asked.defaultValue().ifPresent(values::add);
            }
        }
    }
}
