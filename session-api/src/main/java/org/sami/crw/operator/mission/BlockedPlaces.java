package org.sami.crw.operator.mission;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.crw.operator.mission.Wait.BlockedTransition;
import org.sami.spn.engine.EnablingExplanation;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** Finds out what missions that go on wait for, place by place. */
public final class BlockedPlaces {
    /** They can come at any time to any mission: nobody waits for them. */
    private static final Set<EventRole> ANY_TIME = EnumSet.of(EventRole.ABORT_RECEIVED, EventRole.COMPLETE_RECEIVED);

    private final Vocabulary vocabulary;
    private final EngineView view;

    private BlockedPlaces(Vocabulary vocabulary, EngineView view) {
        this.vocabulary = vocabulary;
        this.view = view;
    }

    /** What all missions wait for, parents before their sub-missions, each by its places in the plan's order; like ones once. */
    public static List<Wait> of(Vocabulary vocabulary, EngineView view) {
        BlockedPlaces waits = new BlockedPlaces(vocabulary, view);
        List<Wait> all = new ArrayList<>();
        view.missions().forEach(mission -> view.plan(mission.plan()).ifPresent(plan -> waits.add(mission, plan, all)));
        return merged(all);
    }

    /** What one mission waits for, by its places in the plan's order; empty where it is not known. */
    public static List<Wait> of(Vocabulary vocabulary, EngineView view, MissionView mission) {
        List<Wait> all = new ArrayList<>();
        view.plan(mission.plan()).ifPresent(plan -> new BlockedPlaces(vocabulary, view).add(mission, plan, all));
        return all;
    }

    private static List<Wait> merged(List<Wait> all) {
        Map<Wait, Integer> counts = new LinkedHashMap<>();
        all.forEach(wait -> counts.merge(wait, 1, Integer::sum));
        return counts.entrySet().stream().map(e -> e.getKey().of(e.getValue())).toList();
    }

    private static List<String> who(List<Token> tokens) {
        Map<String, Integer> counts = new LinkedHashMap<>();
        tokens.forEach(token -> counts.merge(EngineText.token(token), 1, Integer::sum));
        return counts.entrySet().stream()
                .map(e -> e.getValue() == 1 ? e.getKey() : e.getKey() + " x" + e.getValue())
                .toList();
    }

    private void add(MissionView mission, Plan plan, List<Wait> all) {
        Map<String, List<Token>> standing = new LinkedHashMap<>();
        Set<String> visited = view.openActivations().stream()
                .filter(activation -> activation.mission() == mission.id())
                .map(activation -> activation.place())
                .collect(Collectors.toSet());
        for (Place place : plan.places()) {
            List<Token> tokens = mission.marking().getOrDefault(place.id(), List.of());
            if (!tokens.isEmpty() || visited.contains(place.id())) {
                standing.put(place.id(), tokens);
            }
        }
        if (mission.status() != MissionStatus.RUNNING) {
            String place = standing.keySet().stream()
                    .findFirst()
                    .or(() -> plan.startPlace().map(Place::id))
                    .orElse("");
            all.add(new Wait(
                    1,
                    plan.id(),
                    name(plan, place),
                    List.of(),
                    mission.status() == MissionStatus.HALTED
                            ? "nothing: halted as a livelock"
                            : "the values that the plan asks at its start",
                    List.of()));
            return;
        }
        standing.forEach((place, tokens) -> all.add(at(mission, plan, place, tokens)));
        if (standing.isEmpty() && !isShared(mission)) {
            all.add(new Wait(1, plan.id(), "", List.of(), unmarked(plan), List.of()));
        }
    }

    private static String name(Plan plan, String place) {
        return plan.place(place).map(Place::name).filter(n -> !n.isEmpty()).orElse(place);
    }

    /** What lets a mission go on at a place, and the transitions out of it. */
    private Wait at(MissionView mission, Plan plan, String place, List<Token> tokens) {
        Set<String> events = new LinkedHashSet<>();
        Set<String> reasons = new LinkedHashSet<>();
        List<BlockedTransition> transitions = new ArrayList<>();
        for (InEdge edge : plan.inEdges()) {
            Transition transition = plan.transition(edge.transition()).orElseThrow();
            if (!edge.place().equals(place) || comesAtAnyTime(transition)) {
                continue;
            }
            EnablingExplanation why = view.whyNotEnabled(mission.id(), transition.id());
            transitions.add(new BlockedTransition(EngineText.transition(plan, transition.id()), why.reasons()));
            if (why.awaitedSubMissions().contains(place)) {
                running(mission, place).forEach(child -> events.add("the end of " + child));
            }
            if (why.awaited().isEmpty()) {
                reasons.addAll(why.reasons());
            } else {
                events.add(words(why.awaited()));
            }
        }
        String occurrence = !events.isEmpty()
                ? String.join(" or ", events)
                : reasons.isEmpty()
                        ? "nothing: only an abort or completion leads on"
                        : "other tokens: " + String.join(" ", reasons);
        return new Wait(1, plan.id(), name(plan, place), who(tokens), occurrence, transitions);
    }

    /** The sub-missions of a place that run, by name. */
    private List<String> running(MissionView mission, String place) {
        return view.missions().stream()
                .filter(child -> child.parent() == mission.id() && child.place().equals(place))
                .map(child -> view.plan(child.plan()).map(Plan::title).orElse(child.plan()))
                .toList();
    }

    /** Whether it is a shared instance: with nobody in it it waits for nothing, and nobody waits for it. */
    private boolean isShared(MissionView mission) {
        return view.mission(mission.parent()).flatMap(parent -> view.plan(parent.plan())).stream()
                .flatMap(parent -> parent.place(mission.place()).stream())
                .flatMap(place -> place.subMissions().stream())
                .anyMatch(spec -> spec.shared() && spec.plan().equals(mission.plan()));
    }

    private String unmarked(Plan plan) {
        String events = plan.transitions().stream()
                .filter(t -> !t.inputs().isEmpty() && !comesAtAnyTime(t))
                .filter(t -> plan.inEdgesOf(t.id()).isEmpty())
                .map(t -> words(t.inputs()))
                .distinct()
                .collect(Collectors.joining(" or "));
        return events.isEmpty() ? "nothing: no place is marked" : events;
    }

    private boolean comesAtAnyTime(Transition transition) {
        return !transition.inputs().isEmpty()
                && transition.inputs().stream()
                        .allMatch(input -> vocabulary
                                .event(input.type())
                                .map(EventType::role)
                                .filter(ANY_TIME::contains)
                                .isPresent());
    }

    private static String words(List<InputEventSpec> inputs) {
        return inputs.stream().map(BlockedPlaces::word).collect(Collectors.joining(" and "));
    }

    private static String word(InputEventSpec input) {
        return input.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue name
                ? input.type() + " '" + name.value() + "'"
                : input.type();
    }
}
