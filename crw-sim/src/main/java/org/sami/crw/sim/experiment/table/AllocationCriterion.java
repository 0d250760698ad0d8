package org.sami.crw.sim.experiment.table;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Project;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.Value;

/** Sets one criterion by which all plans divide locations, so that a comparison of plans does not compare allocators. */
final class AllocationCriterion {
    private static final String REQUEST = "AllocationRequest";
    private static final String MARKUP = "Optimize";
    private static final String OPTION = "criteria";
    private static final Map<String, String> CONSTANTS = new LinkedHashMap<>(Map.of(
            "auction", "COMPUTATION_TIME",
            "computation-time", "COMPUTATION_TIME",
            "execution-time", "EXECUTION_TIME",
            "execution-safety", "EXECUTION_SAFETY",
            "execution-efficiency", "EXECUTION_EFFICIENCY"));

    private AllocationCriterion() {}

    /**
     * The vocabulary's word for a criterion.
     *
     * @throws IllegalArgumentException where there is none such
     */
    static String constant(String word) {
        String constant = CONSTANTS.get(word.toLowerCase(Locale.ROOT));
        if (constant == null) {
            throw new IllegalArgumentException(
                    "allocation is auction, execution-time, execution-safety or execution-efficiency, not '" + word
                            + "'");
        }
        return constant;
    }

    /** The project with this criterion in all its requests for an allocation. */
    static Project inAll(Project project, String constant) {
        return OutputEvents.changed(
                project, (plan, output) -> output.type().equals(REQUEST) ? with(output, constant) : output);
    }

    private static OutputEventSpec with(OutputEventSpec output, String constant) {
        return output.withMarkups(output.markups().stream()
                .map(markup -> markup.type().equals(MARKUP) ? with(markup, constant) : markup)
                .toList());
    }

    private static MarkupSpec with(MarkupSpec markup, String constant) {
        Map<String, Value> options = new LinkedHashMap<>(markup.options());
        options.computeIfPresent(
                OPTION,
                (name, old) -> old instanceof EnumValue criterion ? new EnumValue(criterion.type(), constant) : old);
        return new MarkupSpec(markup.type(), options);
    }
}
