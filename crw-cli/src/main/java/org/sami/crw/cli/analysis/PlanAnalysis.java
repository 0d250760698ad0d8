package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.Optional;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.planspace.PlanFacts;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.planspace.PlanQueryAnswer.Result;

/**
 * What {@code crw analyse} has found about a plan.
 *
 * @param kind where its queries come from
 * @param facts what holds of all states, up to an exchange of boats; empty where queries were given
 */
record PlanAnalysis(PlanArgument plan, Kind kind, Optional<PlanFacts> facts, List<PlanQueryAnswer> answers) {
    /** What every plan is asked that has no queries of its own. */
    private static final List<String> USUAL = List.of("deadlock", "home ended");

    /** Where queries come from. */
    enum Kind {
        GIVEN,
        SAVED,
        USUAL
    }

    PlanAnalysis {
        answers = List.copyOf(answers);
    }

    /**
     * Searches.
     *
     * @param given texts of queries; where there are none the plan's own are answered, and if it has none the usual ones
     * @param structure whether the structure of the net is asked before its states are searched
     * @throws UsageFault if a given query makes no sense
     */
    static PlanAnalysis of(
            PlanArgument plan, List<String> given, SearchBudget budget, boolean structure, GraphWatch watch) {
        PlanQueries queries = new PlanQueries(plan.net(), budget, watch, structure);
        for (String text : given) {
            queries.fault(text).ifPresent(fault -> {
                throw new UsageFault("--query '" + text + "', " + fault);
            });
        }
        Kind kind = !given.isEmpty() ? Kind.GIVEN : plan.plan().queries().isEmpty() ? Kind.USUAL : Kind.SAVED;
        List<PlanQuery> asked = kind == Kind.SAVED
                ? plan.plan().queries()
                : (kind == Kind.GIVEN ? given : USUAL)
                        .stream()
                                .map(text -> new PlanQuery(text, text, PlanQuery.Expected.YES))
                                .toList();
        Optional<PlanFacts> facts = kind == Kind.GIVEN ? Optional.empty() : Optional.of(queries.whole());
        return new PlanAnalysis(
                plan, kind, facts, asked.stream().map(queries::answer).toList());
    }

    Optional<ReachabilityGraph> graph() {
        return facts.map(PlanFacts::graph);
    }

    /** Whether it is certain that a rule is broken, or a saved query has another answer than its author expects; or one means nothing. */
    boolean hasFound() {
        return answers.stream()
                .anyMatch(answer -> kind == Kind.SAVED
                        ? answer.result() == Result.UNEXPECTED || answer.result() == Result.FAULT
                        : answer.isFault());
    }

    /** The answers of which only the net is known to do what they say: the plan may. */
    List<PlanQueryAnswer> mayBe() {
        return answers.stream().filter(PlanQueryAnswer::mayBe).toList();
    }

    /** Whether the budget ended a search before all was known, or the net does not follow all that the plan does. */
    boolean isOpen() {
        return graph().filter(found -> !found.isComplete()).isPresent()
                || answers.stream()
                        .anyMatch(answer -> answer.verdict() == NetVerdict.UNKNOWN && answer.result() != Result.FAULT);
    }
}
