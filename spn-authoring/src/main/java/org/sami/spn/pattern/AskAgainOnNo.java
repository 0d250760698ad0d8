package org.sami.spn.pattern;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.wizard.LeadBack;

/**
 * No leads back: to the question itself, or, where the operator rejects all options, to the request that made them, so that there are others
 * to choose from.
 */
final class AskAgainOnNo implements Pattern {
    @Override
    public String id() {
        return "ask-again-on-no";
    }

    @Override
    public String title() {
        return "Ask again on no";
    }

    @Override
    public String help() {
        return "Select a place with a question that can be answered by no. No leads back to the question; where options are rejected, to the "
                + "request that made them.";
    }

    @Override
    public Optional<String> refusal(PatternSpot spot) {
        if (spot.places().size() != 1 || question(spot).isEmpty()) {
            return Optional.of("Select one place with a question that the operator can answer by no");
        }
        Optional<Transition> no = no(spot);
        if (no.isEmpty()) {
            return Optional.empty();
        }
        List<OutEdge> out = spot.plan().outEdgesOf(no.get().id());
        if (out.stream().anyMatch(e -> e.place().equals(target(spot)))) {
            return Optional.of("No leads back already");
        }
        return out.stream().allMatch(e -> isUnused(spot.plan(), e.place()))
                ? Optional.empty()
                : Optional.of("No already leads elsewhere");
    }

    @Override
    public Edit edit(PatternSpot spot) {
        Place asking = spot.places().get(0);
        String rejected = question(spot).orElseThrow().rejected();
        Optional<Transition> no = no(spot);
        List<String> unused = no.map(t -> spot.plan().outEdgesOf(t.id()).stream()
                        .map(OutEdge::place)
                        .toList())
                .orElse(List.of());
        LeadBack back = new LeadBack(
                spot.plan().id(),
                asking.id(),
                rejected,
                no.map(Transition::id),
                target(spot),
                spot.mode(),
                spot.library());
        return new PatternEdit(spot.plan().id(), title() + ": " + spot.name(asking), (plan, context) -> {
            Plan cleared =
                    unused.isEmpty() ? plan : new RemoveElements(plan.id(), Set.copyOf(unused)).change(plan, context);
            Plan without = cleared.withOutEdges(cleared.outEdges().stream()
                    .filter(e -> cleared.place(e.place()).isPresent())
                    .toList());
            return back.change(without, context);
        });
    }

    private static Optional<DecisionType> question(PatternSpot spot) {
        return spot.places().stream()
                .flatMap(p -> p.outputs().stream())
                .map(OutputEventSpec::type)
                .flatMap(type -> spot.vocabulary().event(type).stream())
                .map(EventType::decision)
                .flatMap(Optional::stream)
                .filter(d -> !d.rejected().isEmpty())
                .findFirst();
    }

    /** The transition that takes the no. */
    private static Optional<Transition> no(PatternSpot spot) {
        String rejected = question(spot).map(DecisionType::rejected).orElse("");
        return spot.plan().inEdges().stream()
                .filter(e -> e.place().equals(spot.places().get(0).id()))
                .map(e -> spot.plan().transition(e.transition()))
                .flatMap(Optional::stream)
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(rejected)))
                .findFirst();
    }

    private static boolean isUnused(Plan plan, String place) {
        return plan.place(place)
                        .filter(p -> p.outputs().isEmpty() && p.subMissions().isEmpty() && !p.end() && !p.start())
                        .isPresent()
                && plan.inEdges().stream().noneMatch(e -> e.place().equals(place))
                && plan.outEdges().stream().filter(e -> e.place().equals(place)).count() == 1;
    }

    /** The place that is entered again. */
    private static String target(PatternSpot spot) {
        String asking = spot.places().get(0).id();
        boolean options = question(spot)
                .filter(d -> d.form() == DecisionForm.CHOOSE_OPTION)
                .isPresent();
        return options ? request(spot, asking).orElse(asking) : asking;
    }

    /** The place whose answered request leads to a place. */
    private static Optional<String> request(PatternSpot spot, String asking) {
        return spot.plan().outEdges().stream()
                .filter(e -> e.place().equals(asking))
                .map(e -> spot.plan().transition(e.transition()))
                .flatMap(Optional::stream)
                .flatMap(t -> spot.plan().inEdgesOf(t.id()).stream()
                        .filter(e -> asksFor(spot, e.place(), t))
                        .map(e -> e.place()))
                .findFirst();
    }

    private static boolean asksFor(PatternSpot spot, String place, Transition answer) {
        return spot.plan().place(place).stream()
                .flatMap(p -> p.outputs().stream())
                .flatMap(o -> spot.vocabulary().event(o.type()).stream())
                .filter(e -> e.decision().isEmpty())
                .anyMatch(
                        e -> answer.inputs().stream().anyMatch(i -> e.answers().contains(i.type())));
    }
}
