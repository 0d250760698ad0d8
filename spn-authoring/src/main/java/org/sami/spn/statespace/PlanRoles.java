package org.sami.spn.statespace;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.value.EnumValue;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** What places and transitions of a plan are for, as far as searches ask: who brings tokens there, and whether they wait there. */
final class PlanRoles {
    private static final Set<EventRole> BUTTONS =
            EnumSet.of(EventRole.INTERRUPT, EventRole.GENERAL_INTERRUPT_RECEIVED, EventRole.PROXY_INTERRUPT_RECEIVED);
    private static final Set<EventRole> NEVER_HAPPENS =
            EnumSet.of(EventRole.ABORT_RECEIVED, EventRole.COMPLETE_RECEIVED, EventRole.SUB_MISSION_ABORTED);
    private static final Set<TokenKind> SOMEBODY =
            EnumSet.of(TokenKind.ANY_PROXY, TokenKind.ANY_TASK, TokenKind.ANY_TOKEN, TokenKind.TASK);

    private final Plan plan;
    private final Vocabulary vocabulary;

    PlanRoles(Plan plan, Vocabulary vocabulary) {
        this.plan = plan;
        this.vocabulary = vocabulary;
    }

    private Stream<EventType> inputs(Transition t) {
        return t.inputs().stream().flatMap(input -> vocabulary.event(input.type()).stream());
    }

    private Stream<EventType> outputs(Place place) {
        return place.outputs().stream().flatMap(output -> vocabulary.event(output.type()).stream());
    }

    private Stream<Place> placesBefore(Transition t) {
        return plan.inEdgesOf(t.id()).stream().map(InEdge::place).flatMap(id -> plan.place(id).stream());
    }

    // ---- Places

    /**
     * Whether something is asked there that is answered, a sub-mission runs, or news is waited for. Who was not chosen from among those there
     * is asked nothing.
     */
    boolean isWork(Place place) {
        return !isChoice(place)
                && (!place.subMissions().isEmpty()
                        || outputs(place).anyMatch(type -> !type.answers().isEmpty())
                        || waitsForNews(place));
    }

    private boolean waitsForNews(Place place) {
        return plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place.id()) && wantsSomebody(edge))
                .flatMap(edge -> plan.transition(edge.transition()).stream())
                .anyMatch(t -> inputs(t).anyMatch(type -> type.role() == EventRole.NONE));
    }

    /** Whether the operator chooses robots from among those who stand there. */
    boolean isChoice(Place place) {
        return outputs(place)
                .flatMap(type -> type.decision().stream())
                .anyMatch(decision -> decision.form() == DecisionForm.CHOOSE_PROXIES);
    }

    /** Whether nothing leads on from a place and the operator alone puts somebody there: who stands there is left out as he wants it. */
    boolean isLeftOutByOperator(Place place) {
        List<Transition> into = plan.outEdges().stream()
                .filter(edge -> edge.place().equals(place.id()))
                .flatMap(edge -> plan.transition(edge.transition()).stream())
                .toList();
        boolean leadsOn = plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place.id()))
                .anyMatch(this::wantsSomebody);
        return !leadsOn && !into.isEmpty() && into.stream().allMatch(this::isByOperator);
    }

    private boolean wantsSomebody(InEdge edge) {
        return edge.requirements().stream().anyMatch(r -> r.match() != Match.ZERO && r.match() != Match.LESS_THAN);
    }

    // ---- Transitions

    /** Whether the operator brings it about, by a button or an answer. */
    boolean isByOperator(Transition t) {
        return isByButton(t)
                || (!t.inputs().isEmpty()
                        && inputs(t)
                                .allMatch(type -> decisions(t)
                                        .anyMatch(
                                                decision -> decision.accepted().equals(type.name())
                                                        || decision.rejected().equals(type.name()))));
    }

    private Stream<DecisionType> decisions(Transition t) {
        return placesBefore(t).flatMap(this::outputs).flatMap(type -> type.decision().stream());
    }

    /** Whether the operator brings it about by a button. */
    boolean isByButton(Transition t) {
        return inputs(t).anyMatch(type -> BUTTONS.contains(type.role()));
    }

    /**
     * Whether searches do not bring it about: nobody aborts or completes a mission in them, and who is answered at once by autonomy is not
     * answered otherwise; where it asks for fewer robots or tasks, that may be so with fewer.
     */
    boolean isUntried(Transition t) {
        return inputs(t).anyMatch(type -> NEVER_HAPPENS.contains(type.role()))
                || isAnsweredByAutonomy(t)
                || asksForFew(t);
    }

    private boolean isAnsweredByAutonomy(Transition t) {
        List<OutputEventSpec> atOnce = placesBefore(t)
                .flatMap(place -> place.outputs().stream())
                .filter(PlanRoles::isAutonomousAtOnce)
                .toList();
        return atOnce.stream()
                .flatMap(output -> vocabulary.event(output.type()).stream())
                .flatMap(type -> type.decision().stream())
                .anyMatch(decision -> inputs(t).anyMatch(type -> type.name().equals(decision.rejected())));
    }

    private static boolean isAutonomousAtOnce(OutputEventSpec output) {
        return output.markups().stream()
                .filter(markup -> markup.type().equals(Reserved.MIXED_INITIATIVE_TRIGGER))
                .flatMap(markup -> Optional.ofNullable(markup.options().get(Reserved.TRIGGER)).stream())
                .anyMatch(trigger ->
                        trigger instanceof EnumValue value && value.constant().equals(Reserved.IMMEDIATELY));
    }

    private boolean asksForFew(Transition t) {
        return t.inputs().isEmpty()
                && plan.inEdgesOf(t.id()).stream()
                        .flatMap(edge -> edge.requirements().stream())
                        .anyMatch(r -> SOMEBODY.contains(r.kind())
                                && (r.match() == Match.ZERO || r.match() == Match.LESS_THAN));
    }
}
