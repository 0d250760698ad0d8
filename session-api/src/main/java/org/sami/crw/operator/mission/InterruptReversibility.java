package org.sami.crw.operator.mission;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Whether a plan leads back to where an interrupt takes robots from: along its edges, whatever they require. What leads nowhere back cannot be undone
 * by anything that the operator does in the mission.
 */
public final class InterruptReversibility {
    private final Plan plan;
    private final Vocabulary vocabulary;

    /** The ways of a plan. */
    public InterruptReversibility(Plan plan, Vocabulary vocabulary) {
        this.plan = plan;
        this.vocabulary = vocabulary;
    }

    /** Why what an interrupt does cannot be undone, in one sentence; empty text where the plan leads back. */
    public String missingAfter(String interrupt) {
        return plan.transitions().stream()
                .filter(transition -> isTakenBy(transition, interrupt))
                .map(this::missing)
                .flatMap(Optional::stream)
                .distinct()
                .collect(Collectors.joining(" "));
    }

    private boolean isTakenBy(Transition transition, String interrupt) {
        boolean named = transition.inputs().stream()
                .anyMatch(input -> role(input.type()) == EventRole.INTERRUPT
                        && input.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue text
                        && text.value().equals(interrupt));
        boolean answersPlace = transition.inputs().stream()
                        .map(input -> role(input.type()))
                        .anyMatch(role -> role == EventRole.GENERAL_INTERRUPT_RECEIVED
                                || role == EventRole.PROXY_INTERRUPT_RECEIVED)
                && from(transition).stream().anyMatch(place -> offers(place, interrupt));
        return named || answersPlace;
    }

    private boolean offers(String id, String interrupt) {
        return plan.places().stream()
                .filter(place -> place.id().equals(id))
                .flatMap(place -> place.outputs().stream())
                .anyMatch(output -> {
                    FieldSource source = output.fields().get(Reserved.INTERRUPT_NAME);
                    Value value = source instanceof FieldSource.Fixed fixed ? fixed.value() : null;
                    return value instanceof TextValue text && text.value().equals(interrupt);
                });
    }

    private EventRole role(String type) {
        return vocabulary.event(type).map(EventType::role).orElse(EventRole.NONE);
    }

    private Optional<String> missing(Transition transition) {
        Set<String> from = from(transition);
        Set<String> to = to(transition);
        Set<String> left = new LinkedHashSet<>(from);
        left.removeAll(to);
        left.removeIf(this::isButton);
        to.removeAll(from);
        to.removeIf(this::isButton);
        if (left.isEmpty()) {
            return to.stream().anyMatch(this::isEnd)
                    ? Optional.of("It leads to the end of the mission.")
                    : Optional.empty();
        }
        if (reached(to).stream().anyMatch(left::contains)) {
            return Optional.empty();
        }
        return Optional.of("Nothing leads back from " + names(to) + " to " + names(left) + ".");
    }

    private Set<String> reached(Set<String> begin) {
        Set<String> reached = new LinkedHashSet<>(begin);
        Deque<String> next = new ArrayDeque<>(begin);
        while (!next.isEmpty()) {
            String place = next.poll();
            for (Transition transition : plan.transitions()) {
                if (from(transition).contains(place)) {
                    to(transition).stream().filter(reached::add).forEach(next::add);
                }
            }
        }
        return reached;
    }

    private boolean isButton(String id) {
        return plan.places().stream()
                .filter(place -> place.id().equals(id))
                .flatMap(place -> place.outputs().stream())
                .map(output -> role(output.type()))
                .anyMatch(role -> role == EventRole.GENERAL_INTERRUPT || role == EventRole.PROXY_INTERRUPT);
    }

    private boolean isEnd(String id) {
        return plan.places().stream().anyMatch(place -> place.id().equals(id) && place.end());
    }

    private String names(Set<String> ids) {
        List<String> names = new ArrayList<>();
        for (Place place : plan.places()) {
            if (ids.contains(place.id())) {
                names.add("'" + (place.name().isEmpty() ? place.id() : place.name()) + "'");
            }
        }
        return names.isEmpty() ? "nowhere" : String.join(", ", names);
    }

    private Set<String> from(Transition transition) {
        return plan.inEdges().stream()
                .filter(edge -> edge.transition().equals(transition.id()))
                .map(InEdge::place)
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private Set<String> to(Transition transition) {
        return plan.outEdges().stream()
                .filter(edge -> edge.transition().equals(transition.id()))
                .map(OutEdge::place)
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }
}
