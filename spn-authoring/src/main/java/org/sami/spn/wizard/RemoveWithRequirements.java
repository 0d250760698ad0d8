package org.sami.spn.wizard;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.sami.spn.edit.EditContext;
import org.sami.spn.edit.EditRefusedException;
import org.sami.spn.edit.PlanEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.AuthoringLibrary;

/** Deletes elements as {@link RemoveElements} does, and adjusts the requirements that are no longer needed (thesis 5.1.1). */
public record RemoveWithRequirements(String plan, Set<String> elements, AuthoringLibrary library) implements PlanEdit {
    public RemoveWithRequirements {
        Objects.requireNonNull(plan, "plan");
        elements = Collections.unmodifiableSet(new LinkedHashSet<>(elements));
        Objects.requireNonNull(library, "library");
    }

    @Override
    public String label() {
        return new RemoveElements(plan, elements).label();
    }

    @Override
    public Plan change(Plan before, EditContext context) throws EditRefusedException {
        Plan removed = new RemoveElements(plan, elements).change(before, context);
        Predicate<InEdge> joinsIn = e -> joins(removed, e.place(), e.transition());
        Predicate<OutEdge> joinsOut = e -> joins(removed, e.place(), e.transition());
        Plan joined = removed.withInEdges(
                        removed.inEdges().stream().filter(joinsIn).toList())
                .withOutEdges(removed.outEdges().stream().filter(joinsOut).toList());
        Plan adjusted = new RequirementComputation(context.vocabulary(), library).adjusted(before, joined);
        // edges without an end are removed as well and reported, as with every edit
        return adjusted.withInEdges(both(
                        adjusted.inEdges(),
                        removed.inEdges().stream().filter(joinsIn.negate()).toList()))
                .withOutEdges(both(
                        adjusted.outEdges(),
                        removed.outEdges().stream().filter(joinsOut.negate()).toList()));
    }

    private static boolean joins(Plan plan, String place, String transition) {
        return plan.place(place).isPresent() && plan.transition(transition).isPresent();
    }

    private static <T> List<T> both(List<T> a, List<T> b) {
        return Stream.concat(a.stream(), b.stream()).toList();
    }
}
