package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.crw.markup.MarkupReader;
import org.sami.crw.operator.mission.BlockedPlaces;
import org.sami.crw.operator.mission.InterruptChoice;
import org.sami.crw.operator.mission.InterruptReversibility;
import org.sami.crw.operator.mission.MissionSnapshot.Details;
import org.sami.spn.engine.EnablingExplanation;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.InterruptButton;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What only the engine knows of its missions at one moment: which answers they keep, what they wait for, and which interrupts have buttons.
 *
 * @param details by mission
 */
record EngineSnapshot(Map<Long, Details> details, List<InterruptChoice> buttons) {

    /** Asks; on the thread that owns the state. */
    static EngineSnapshot at(EngineView view, Vocabulary vocabulary) {
        Map<Long, Details> details = new HashMap<>();
        List<InterruptChoice> buttons = new ArrayList<>();
        Map<Long, Map<String, Boolean>> offered = new HashMap<>();
        for (InterruptButton button : view.interrupts()) {
            offered.computeIfAbsent(button.mission(), id -> new LinkedHashMap<>())
                    .put(button.name(), button.asksForProxies());
        }
        for (MissionView mission : view.missions()) {
            details.put(
                    mission.id(),
                    new Details(view.pendingAnswers(mission.id()), BlockedPlaces.of(vocabulary, view, mission)));
            view.planOf(mission.id())
                    .ifPresent(plan -> addButtons(
                            view, vocabulary, mission, plan, offered.getOrDefault(mission.id(), Map.of()), buttons));
        }
        return new EngineSnapshot(details, buttons);
    }

    private static void addButtons(
            EngineView view,
            Vocabulary vocabulary,
            MissionView mission,
            Plan plan,
            Map<String, Boolean> offered,
            List<InterruptChoice> buttons) {
        InterruptReversibility ways = new InterruptReversibility(plan, vocabulary);
        Map<String, OptionalLong> asking = asking(view, mission.id());
        for (Map.Entry<String, Optional<Place>> each :
                inPlanOrder(vocabulary, plan, offered.keySet()).entrySet()) {
            String name = each.getKey();
            boolean isOffered = offered.containsKey(name);
            boolean asks = isOffered
                    ? offered.get(name)
                    : each.getValue().stream().anyMatch(place -> asksForBoats(vocabulary, place, name));
            String why = isOffered
                    ? whyNot(view, vocabulary, mission, plan, name)
                    : each.getValue()
                            .map(place ->
                                    "No token stands in '" + (place.name().isEmpty() ? place.id() : place.name()) + "'")
                            .orElse("The plan does not offer it now");
            buttons.add(button(
                    vocabulary,
                    mission,
                    plan,
                    name,
                    asks,
                    ways.missingAfter(name),
                    asking.getOrDefault(name, OptionalLong.empty()),
                    why));
        }
    }

    /** The latest open question of each interrupt whom it is for. */
    private static Map<String, OptionalLong> asking(EngineView view, long mission) {
        Map<String, OptionalLong> asking = new HashMap<>();
        for (Decision decision : view.decisions()) {
            if (decision.mission() == mission && decision.isInterruptChoice()) {
                asking.put(decision.type().substring(Decision.INTERRUPT.length()), OptionalLong.of(decision.id()));
            }
        }
        return asking;
    }

    /**
     * All interrupts of a plan, offered now or not, in an order that stays for the life of its mission: those of its transitions and places, then
     * those whose names the plan does not have. With the place that offers each, if any.
     */
    private static Map<String, Optional<Place>> inPlanOrder(Vocabulary vocabulary, Plan plan, Set<String> offered) {
        Map<String, Optional<Place>> all = new LinkedHashMap<>();
        for (Transition transition : plan.transitions()) {
            for (InputEventSpec input : transition.inputs()) {
                if (role(vocabulary, input.type()) == EventRole.INTERRUPT
                        && input.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue name) {
                    all.putIfAbsent(name.value(), Optional.empty());
                }
            }
        }
        for (Place place : plan.places()) {
            for (OutputEventSpec output : place.outputs()) {
                if (isButton(role(vocabulary, output.type()))) {
                    name(output.fields().get(Reserved.INTERRUPT_NAME))
                            .ifPresent(name -> all.putIfAbsent(name, Optional.of(place)));
                }
            }
        }
        offered.forEach(name -> all.putIfAbsent(name, Optional.empty()));
        return all;
    }

    private static boolean isButton(EventRole role) {
        return role == EventRole.GENERAL_INTERRUPT || role == EventRole.PROXY_INTERRUPT;
    }

    private static boolean asksForBoats(Vocabulary vocabulary, Place place, String name) {
        return place.outputs().stream()
                .anyMatch(output -> role(vocabulary, output.type()) == EventRole.PROXY_INTERRUPT
                        && name(output.fields().get(Reserved.INTERRUPT_NAME)).equals(Optional.of(name)));
    }

    /** With what the markup of the events says that offer it or take it. */
    private static InterruptChoice button(
            Vocabulary vocabulary,
            MissionView mission,
            Plan plan,
            String name,
            boolean asks,
            String noWayBack,
            OptionalLong asking,
            String whyNot) {
        List<MarkupSpec> markups = new ArrayList<>();
        for (Transition transition : plan.transitions()) {
            transition.inputs().stream()
                    .filter(input -> isPress(role(vocabulary, input.type())) && isNamed(input, name))
                    .forEach(input -> markups.addAll(input.markups()));
        }
        for (Place place : plan.places()) {
            place.outputs().stream()
                    .filter(output ->
                            name(output.fields().get(Reserved.INTERRUPT_NAME)).equals(Optional.of(name)))
                    .forEach(output -> markups.addAll(output.markups()));
        }
        MarkupReader reader = new MarkupReader(markups);
        return new InterruptChoice(
                mission.id(),
                plan.title(),
                name,
                asks,
                reader.constant("Priority", "rank", Priority.class).orElse(Priority.MEDIUM),
                reader.text("Description", "source"),
                noWayBack,
                asking,
                whyNot);
    }

    /** Why no transition could take a press; empty where one could, as far as it does not depend on the boats that are chosen. */
    private static String whyNot(EngineView view, Vocabulary vocabulary, MissionView mission, Plan plan, String name) {
        List<String> reasons = new ArrayList<>();
        for (Transition transition : plan.transitions()) {
            Optional<InputEventSpec> press = transition.inputs().stream()
                    .filter(input -> isPress(role(vocabulary, input.type())) && isNamed(input, name))
                    .findFirst();
            if (press.isPresent()) {
                EnablingExplanation why = view.whyNotEnabled(mission.id(), transition.id());
                String pressed = "It waits for " + vocabulary.title(press.get().type());
                List<String> others = why.reasons().stream()
                        .filter(reason -> !reason.startsWith(pressed))
                        .toList();
                if (others.isEmpty()) {
                    return "";
                }
                others.stream().filter(reason -> !reasons.contains(reason)).forEach(reasons::add);
            }
        }
        return String.join(" ", reasons);
    }

    private static boolean isPress(EventRole role) {
        return role == EventRole.INTERRUPT
                || role == EventRole.GENERAL_INTERRUPT_RECEIVED
                || role == EventRole.PROXY_INTERRUPT_RECEIVED;
    }

    private static boolean isNamed(InputEventSpec input, String name) {
        return input.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue text
                && text.value().equals(name);
    }

    private static Optional<String> name(@Nullable FieldSource source) {
        Value value = source instanceof FieldSource.Fixed fixed ? fixed.value() : null;
        return value instanceof TextValue text ? Optional.of(text.value()) : Optional.empty();
    }

    private static EventRole role(Vocabulary vocabulary, String type) {
        return vocabulary.event(type).map(EventType::role).orElse(EventRole.NONE);
    }
}
