package org.sami.lessons.job;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.wizard.RequirementComputation;

/**
 * Plans of lessons that come before requirements: where an edge has none, all tokens go along it, as such a lesson tells it.
 */
final class FilledRequirements {
    private static final List<InRequirement> IN = List.of(InRequirement.of(TokenKind.ANY_TOKEN, Match.AT_LEAST, 1));
    private static final List<OutRequirement> OUT =
            List.of(OutRequirement.of(Action.TAKE, OutRequirement.ALL, TokenKind.ANY_TOKEN));

    private FilledRequirements() {}

    /** Computes the requirements of all edges anew, as the inspector does. */
    static Project computed(Project project, DomainLibrary domain) {
        RequirementComputation computation = new RequirementComputation(domain.vocabulary(), domain.authoring());
        return project.withPlans(project.plans().stream()
                .map(plan -> computation.computed(plan, edges(plan)))
                .toList());
    }

    private static Set<String> edges(Plan plan) {
        Set<String> edges = new LinkedHashSet<>();
        plan.inEdges().forEach(edge -> edges.add(edge.id()));
        plan.outEdges().forEach(edge -> edges.add(edge.id()));
        return edges;
    }

    static Project in(Project project) {
        return project.withPlans(
                project.plans().stream().map(FilledRequirements::in).toList());
    }

    private static Plan in(Plan plan) {
        List<InEdge> ins = plan.inEdges().stream()
                .map(edge -> edge.requirements().isEmpty() ? edge.withRequirements(IN) : edge)
                .toList();
        List<OutEdge> outs = plan.outEdges().stream()
                .map(edge -> edge.requirements().isEmpty() ? edge.withRequirements(OUT) : edge)
                .toList();
        return plan.withInEdges(ins).withOutEdges(outs);
    }
}
