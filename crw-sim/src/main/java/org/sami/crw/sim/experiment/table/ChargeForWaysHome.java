package org.sami.crw.sim.experiment.table;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Project;
import org.sami.spn.value.BooleanValue;

/**
 * Has plans divide locations and send boats without keeping charge for the way home. Plans that swap batteries do so by themselves. Where the operator swaps
 * them with plans of their own (thesis 7.1.1), the other plans do not know it, and versions would differ in how they divide.
 */
final class ChargeForWaysHome {
    private static final Set<String> EVENTS =
            Set.of("AllocationRequest", "ProxyExecutePath", "ProxyExecutePathAndBlock");
    private static final String KEEP_HOME = "keepHome";

    private ChargeForWaysHome() {}

    /** The project whose plans keep none. */
    static Project keptByNone(Project project) {
        return OutputEvents.changed(
                project, (plan, output) -> EVENTS.contains(output.type()) ? withoutKeeping(output) : output);
    }

    private static OutputEventSpec withoutKeeping(OutputEventSpec output) {
        Map<String, FieldSource> fields = new LinkedHashMap<>(output.fields());
        fields.put(KEEP_HOME, new FieldSource.Fixed(new BooleanValue(false)));
        return output.withFields(fields);
    }
}
