package org.sami.spn.pattern;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.flow.ComingTokens;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Where a pattern is to stand.
 *
 * @param plan the plan that is changed, one of the project
 * @param selection ids of the selected elements
 * @param mode in which new parts are drawn
 */
public record PatternSpot(
        Project project, Plan plan, Set<String> selection, Mode mode, Vocabulary vocabulary, AuthoringLibrary library) {
    public PatternSpot {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(plan, "plan");
        selection = Set.copyOf(selection);
        Objects.requireNonNull(mode, "mode");
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(library, "library");
    }

    /** The selected places, in the order of the plan. */
    List<Place> places() {
        return plan.places().stream().filter(p -> selection.contains(p.id())).toList();
    }

    /** Which tokens can come to which places. */
    ComingTokens coming() {
        return new ComingTokens(project, plan, vocabulary);
    }

    /** What a place is called. */
    String name(Place place) {
        return "\"" + new ElementNames(plan, vocabulary).of(place) + "\"";
    }
}
