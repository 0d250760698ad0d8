package org.sami.spn.wiring;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * From where the fields of events are read that an addition draws.
 *
 * @param proposed whether fields that the author says nothing about are read from what is proposed for them
 * @param chosen what the author says, by field of the added event; empty for a field that is left open
 */
public record Wires(boolean proposed, Map<String, Optional<DataSource>> chosen) {
    /** Every field is left open. */
    public static final Wires NONE = new Wires(false, Map.of());

    /** Every field is read from what is proposed for it. */
    public static final Wires PROPOSED = new Wires(true, Map.of());

    public Wires {
        chosen = Map.copyOf(chosen);
    }

    /** The same, but for one field of the added event. */
    public Wires with(String field, Optional<DataSource> source) {
        Map<String, Optional<DataSource>> more = new LinkedHashMap<>(chosen);
        more.put(field, Objects.requireNonNull(source, "source"));
        return new Wires(proposed, more);
    }

    /**
     * The project with the fields of the output events read that a plan did not have before.
     *
     * @param type of the added event, whose fields the author speaks of
     * @param wanted by event type, optional fields that are proposed all the same
     */
    public Project wired(
            Project before,
            Project added,
            String plan,
            String type,
            Function<String, Set<String>> wanted,
            EditContext context)
            throws EditRefusedException {
        if (!proposed && chosen.isEmpty()) {
            return added;
        }
        Set<String> old = outputs(before, plan).keySet();
        Project wired = added;
        for (Map.Entry<String, String> output : outputs(added, plan).entrySet()) {
            if (!old.contains(output.getKey())) {
                boolean main = output.getValue().equals(type);
                for (FieldProposal proposal : FieldProposal.of(
                        added, plan, output.getKey(), context.vocabulary(), wanted.apply(output.getValue()))) {
                    Optional<DataSource> source =
                            main && chosen.containsKey(proposal.field().name())
                                    ? chosen.get(proposal.field().name())
                                    : proposed ? proposal.proposed() : Optional.empty();
                    if (source.isPresent()) {
                        wired = wired(wired, plan, output.getKey(), proposal, source.get(), context);
                    }
                }
            }
        }
        return wired;
    }

    private static Project wired(
            Project project, String plan, String event, FieldProposal proposal, DataSource source, EditContext context)
            throws EditRefusedException {
        Plan open = project.plan(plan).orElseThrow();
        String field = proposal.field().name();
        context.tell(field + " is read from " + words(source, context));
        return Wiring.edit(project, open, event, field, proposal.field().type(), source)
                .change(project, context);
    }

    private static String words(DataSource source, EditContext context) {
        return SourceWords.of(source, context.vocabulary());
    }

    /** The types of the output events of a plan, by their ids. */
    private static Map<String, String> outputs(Project project, String plan) {
        Map<String, String> outputs = new LinkedHashMap<>();
        project.plan(plan)
                .ifPresent(p ->
                        p.places().forEach(place -> place.outputs().forEach(o -> outputs.put(o.id(), o.type()))));
        return outputs;
    }
}
