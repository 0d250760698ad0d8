package org.sami.spn.analysis;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/**
 * A transition that goes on when nobody is left in some places looks at all of them: at those from which robots or tasks come one after
 * the other into the place where they gather, and, where it ends the mission, at those that lead to the places that it looks at and to
 * which a way leads back, or which robots or tasks leave one by one. A place is looked at as well where another one counts who is in it
 * (thesis 7.0.3).
 */
final class ForgottenPlaces implements PlanCheck {
    private static final Set<TokenType> NAMED = EnumSet.of(TokenType.PROXY, TokenType.TASK);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-PLACE-FORGOTTEN",
                "The transition fires while somebody is still in the place that it does not look at: that "
                        + "robot or task is left behind.",
                "Let the transition also ask for none (= 0) in that place."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            Set<TokenType> kinds = absent(plan, t);
            if (t.inputs().isEmpty() && !kinds.isEmpty()) {
                Set<Place> forgotten = new LinkedHashSet<>();
                Set<String> watched =
                        plan.inEdges(t).stream().map(InEdge::place).collect(Collectors.toSet());
                addGathered(plan, t, kinds, watched, forgotten);
                if (plan.outPlaces(t).stream().anyMatch(Place::end)) {
                    addBehind(plan, t, kinds, watched, forgotten);
                }
                if (!forgotten.isEmpty()) {
                    report(plan, t, List.copyOf(forgotten), kinds, report);
                }
            }
        }
    }
    /** The kinds with names of which a transition asks that none is left somewhere. */
    private static Set<TokenType> absent(PlanContext plan, Transition t) {
        Set<TokenType> kinds = EnumSet.noneOf(TokenType.class);
        for (InEdge edge : plan.inEdges(t)) {
            edge.requirements().stream()
                    .filter(r -> r.asksForNone() && r.kind() != TokenKind.RELEVANT)
                    .forEach(r -> kinds.addAll(TokenType.of(r.kind())));
        }
        kinds.retainAll(NAMED);
        return kinds;
    }

    /** Places from which some come one after the other into one where the transition waits for them. */
    private static void addGathered(
            PlanContext plan, Transition t, Set<TokenType> kinds, Set<String> watched, Set<Place> forgotten) {
        for (InEdge edge : plan.inEdges(t)) {
            boolean gathers = edge.requirements().stream()
                    .anyMatch(r -> r.match() == Match.AT_LEAST && meets(TokenType.of(r.kind()), kinds));
            boolean plain = plan.place(edge.place())
                    .filter(p -> p.subMissions().isEmpty())
                    .isPresent();
            if (gathers && plain) {
                SingleAnswers.comeSinglyFrom(plan, edge.place()).stream()
                        .filter(place -> !watched.contains(place.id()))
                        .forEach(forgotten::add);
            }
        }
    }

    /** Places to which a way leads from those that the transition looks at, and from which one leads back to them. */
    private static void addBehind(
            PlanContext plan, Transition t, Set<TokenType> kinds, Set<String> watched, Set<Place> forgotten) {
        Set<String> after = plan.flow().reached(watched, kinds, any -> true);
        Set<String> before = leadingTo(plan, watched, kinds);
        for (Place place : plan.plan().places()) {
            if (!watched.contains(place.id())
                    && !place.end()
                    && (after.contains(place.id()) || SingleAnswers.leave(plan, place))
                    && before.contains(place.id())
                    && meets(plan.flow().at(place), kinds)
                    && !isCounted(plan, t, place, kinds)) {
                forgotten.add(place);
            }
        }
    }

    /** The places from which tokens of some kinds may come to others. */
    private static Set<String> leadingTo(PlanContext plan, Set<String> places, Set<TokenType> kinds) {
        Set<String> before = new HashSet<>();
        Deque<String> open = new ArrayDeque<>(places);
        while (!open.isEmpty()) {
            for (OutEdge edge : plan.place(open.pop()).map(plan::edgesInto).orElse(List.of())) {
                if (meets(plan.flow().along(edge), kinds)) {
                    plan.transition(edge.transition()).map(plan::inEdges).orElse(List.of()).stream()
                            .filter(e -> e.requirements().stream().noneMatch(InRequirement::asksForNone))
                            .map(InEdge::place)
                            .filter(before::add)
                            .forEach(open::push);
                }
            }
        }
        return before;
    }

    /** Whether tokens that enter a place count in another one that the transition requires to be empty. */
    private static boolean isCounted(PlanContext plan, Transition t, Place place, Set<TokenType> kinds) {
        List<Transition> entering = plan.edgesInto(place).stream()
                .filter(e -> meets(plan.flow().along(e), kinds))
                .flatMap(e -> plan.transition(e.transition()).stream())
                .toList();
        return plan.inEdges(t).stream()
                .filter(e -> e.requirements().stream().anyMatch(InRequirement::asksForNone))
                .map(InEdge::place)
                .anyMatch(counter -> entering.stream().allMatch(u -> leadsTo(plan, u, counter))
                        || isCountedOnTheWay(plan, t, place, counter, kinds));
    }

    private static boolean leadsTo(PlanContext plan, Transition from, String place) {
        return plan.outEdges(from).stream().anyMatch(e -> e.place().equals(place));
    }

    /** Whether a place does nothing but hold copies. */
    private static boolean holdsCopies(PlanContext plan, String id) {
        return plan.place(id)
                .filter(place ->
                        place.outputs().isEmpty() && place.subMissions().isEmpty())
                .map(plan::edgesInto)
                .filter(edges ->
                        edges.stream().flatMap(e -> e.requirements().stream()).allMatch(r -> r.action() == Action.ADD))
                .isPresent();
    }

    /** Whether a copy of whoever comes to a place was put into another one on the way, and has not been taken out of it again. */
    private static boolean isCountedOnTheWay(
            PlanContext plan, Transition t, Place place, String counter, Set<TokenType> kinds) {
        if (!holdsCopies(plan, counter)) {
            return false;
        }
        Set<String> uncounted = new HashSet<>();
        plan.plan().places().stream().filter(Place::start).map(Place::id).forEach(uncounted::add);
        for (Transition taking : plan.place(counter).map(plan::outTransitions).orElse(List.of())) {
            if (!taking.equals(t)) {
                plan.outPlaces(taking).stream().map(Place::id).forEach(uncounted::add);
            }
        }
        return !uncounted.contains(counter)
                && !uncounted.contains(place.id())
                && !plan.flow()
                        .reached(uncounted, kinds, passed -> !leadsTo(plan, passed, counter))
                        .contains(place.id());
    }

    private static boolean meets(Set<TokenType> some, Set<TokenType> others) {
        return some.stream().anyMatch(others::contains);
    }

    private static void report(
            PlanContext plan, Transition t, List<Place> forgotten, Set<TokenType> kinds, Consumer<Finding> report) {
        String names = forgotten.stream().map(plan::name).collect(Collectors.joining(" and the "));
        List<String> elements = new ArrayList<>(List.of(t.id()));
        forgotten.forEach(place -> elements.add(place.id()));
        report.accept(askingForNone(
                plan,
                t,
                forgotten,
                kinds,
                Finding.warning(
                        "W-PLACE-FORGOTTEN",
                        plan.at(t),
                        plan.transitionName(t.id()) + " fires when nobody is left in some places, and does not look at"
                                + " the " + names + ": somebody may still be there. Ask for none left (= 0) there as"
                                + " well",
                        elements.toArray(String[]::new))));
    }

    /** Offers to ask that nobody is left in some places. */
    static Finding askingForNone(
            PlanContext plan, Transition t, List<Place> places, Set<TokenType> kinds, Finding finding) {
        TokenKind kind = !kinds.contains(TokenType.TASK)
                ? TokenKind.ANY_PROXY
                : kinds.contains(TokenType.PROXY) ? TokenKind.ANY_TOKEN : TokenKind.ANY_TASK;
        List<Edit> edits = new ArrayList<>();
        for (Place place : places) {
            if (plan.inEdges(t).stream().noneMatch(e -> e.place().equals(place.id()))) {
                edits.add(new EdgeEdit.ConnectIn(
                        plan.plan().id(),
                        place.id(),
                        t.id(),
                        t.mode(),
                        List.of(InRequirement.of(kind, Match.ZERO, 0))));
            }
        }
        return edits.isEmpty()
                ? finding
                : finding.fixedBy("Ask for none left there", new EditSequence("Ask for none left", edits));
    }
}
