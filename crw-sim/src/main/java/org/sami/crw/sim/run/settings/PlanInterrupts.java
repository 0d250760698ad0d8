package org.sami.crw.sim.run.settings;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.value.TextNumbers;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The interrupts that a plan and its sub-missions offer, by the names on their buttons, and how a user says that one is to be
 * pressed: {@code NAME[:BOAT]@SECONDS} or {@code NAME[:BOAT]@battery}.
 */
public final class PlanInterrupts {
    /** Stands in the place of a time: pressed for a boat whose battery turns critical. */
    public static final String BATTERY = "battery";

    private static final String FORM = "expected is NAME[:BOAT]@SECONDS or NAME[:BOAT]@" + BATTERY;
    private static final double MOST_SECONDS = 366 * 86_400.0;

    private final Vocabulary vocabulary;
    private final Map<String, Boolean> takesBoats = new LinkedHashMap<>();
    private boolean othersPossible;

    /** The interrupts of a plan, those of its sub-missions after its own. */
    public PlanInterrupts(Vocabulary vocabulary, Project project, Plan plan) {
        this(vocabulary, project, List.of(plan));
    }

    /** The interrupts of several plans, whose missions run together. */
    public PlanInterrupts(Vocabulary vocabulary, Project project, List<Plan> plans) {
        this.vocabulary = vocabulary;
        Set<String> seen = new HashSet<>();
        plans.forEach(plan -> collect(project, plan, seen));
    }

    private void collect(Project project, Plan plan, Set<String> seen) {
        if (!seen.add(plan.id())) {
            return;
        }
        plan.places().forEach(place -> place.outputs().forEach(this::collect));
        plan.transitions().forEach(transition -> collect(plan, transition));
        for (Place place : plan.places()) {
            for (SubMissionSpec child : place.subMissions()) {
                project.plan(child.plan()).ifPresent(p -> collect(project, p, seen));
            }
        }
    }

    private void collect(OutputEventSpec output) {
        EventRole role = roleOf(output.type());
        if (role != EventRole.GENERAL_INTERRUPT && role != EventRole.PROXY_INTERRUPT) {
            return;
        }
        FieldSource source = output.fields().get(Reserved.INTERRUPT_NAME);
        if (source instanceof FieldSource.Fixed fixed && fixed.value() instanceof TextValue name) {
            add(name.value(), role == EventRole.PROXY_INTERRUPT);
        } else {
            othersPossible = true;
        }
    }

    private void collect(Plan plan, Transition transition) {
        for (InputEventSpec input : transition.inputs()) {
            if (roleOf(input.type()) == EventRole.INTERRUPT
                    && input.fields().get(Reserved.INTERRUPT_NAME) instanceof TextValue name) {
                add(name.value(), speaksOfRelevant(plan, transition));
            }
        }
    }

    private static boolean speaksOfRelevant(Plan plan, Transition transition) {
        for (InEdge edge : plan.inEdgesOf(transition.id())) {
            if (edge.requirements().stream().map(InRequirement::kind).anyMatch(TokenKind.RELEVANT::equals)) {
                return true;
            }
        }
        return plan.outEdgesOf(transition.id()).stream()
                .flatMap(edge -> edge.requirements().stream())
                .anyMatch(requirement -> requirement.kind() == TokenKind.RELEVANT);
    }

    private void add(String name, boolean boats) {
        takesBoats.merge(name, boats, Boolean::logicalOr);
    }

    private EventRole roleOf(String type) {
        return vocabulary.event(type).map(EventType::role).orElse(EventRole.NONE);
    }

    /** Whether an interrupt is for boats, which the press names or the operator chooses then. */
    public boolean takesBoats(String name) {
        return takesBoats.getOrDefault(name, true);
    }

    /** How they are pressed, in the plan's order: {@code alarm@SECONDS, recharge[:BOAT]@SECONDS}. */
    public String inWords() {
        return takesBoats.entrySet().stream()
                .map(e -> e.getKey() + (e.getValue() ? "[:BOAT]" : "") + "@SECONDS")
                .collect(Collectors.joining(", "));
    }

    /** The names in the plan's order. */
    public List<String> names() {
        return List.copyOf(takesBoats.keySet());
    }

    /**
     * Reads the user's interrupts.
     *
     * @param boats the names of the run's boats, in order
     * @throws IllegalArgumentException naming the first that makes no sense, and why
     */
    public List<PlannedInterrupt> read(List<String> texts, List<String> boats) {
        List<PlannedInterrupt> planned = new ArrayList<>();
        for (String text : texts) {
            planned.add(read(text, boats));
        }
        return planned;
    }

    /**
     * Checks the user's interrupts, as far as possible before the boats are known.
     *
     * @throws IllegalArgumentException naming the first that makes no sense, and why
     */
    public void check(List<String> texts) {
        texts.forEach(text -> read(text, List.of()));
    }

    private PlannedInterrupt read(String text, List<String> boats) {
        int at = text.lastIndexOf('@');
        if (at < 1) {
            throw new IllegalArgumentException("'" + text + "' does not say when; " + FORM);
        }
        String pressed = text.substring(0, at);
        OptionalLong after = time(text, text.substring(at + 1));
        int colon = pressed.lastIndexOf(':');
        boolean withBoat = colon >= 0 && !takesBoats.containsKey(pressed);
        String name = withBoat ? pressed.substring(0, colon) : pressed;
        if (!takesBoats.containsKey(name) && !othersPossible) {
            throw new IllegalArgumentException("'" + text + "': the plan has no interrupt '" + name + "'; "
                    + (takesBoats.isEmpty() ? "it has none" : "it has " + String.join(", ", takesBoats.keySet())));
        }
        boolean forBoats = takesBoats(name);
        if (!forBoats && (withBoat || after.isEmpty())) {
            throw new IllegalArgumentException("'" + text + "': '" + name + "' is for the whole team; it takes no boat"
                    + (withBoat ? "" : ", and no battery presses it"));
        }
        Optional<String> boat =
                withBoat ? Optional.of(boat(text, pressed.substring(colon + 1), boats)) : Optional.empty();
        return new PlannedInterrupt(name, boat, after);
    }

    private static OptionalLong time(String text, String time) {
        if (time.equals(BATTERY)) {
            return OptionalLong.empty();
        }
        double seconds = TextNumbers.real(time, 0, MOST_SECONDS)
                .orElseThrow(() -> new IllegalArgumentException(
                        "'" + text + "': '" + time + "' is no number of seconds; " + FORM));
        return OptionalLong.of(Math.round(seconds * 1000));
    }

    private static String boat(String text, String named, List<String> boats) {
        if (boats.contains(named) || boats.isEmpty()) { // without boats everybody may be one
            return named;
        }
        if (named.matches("\\d{1,9}")) {
            int number = Integer.parseInt(named);
            if (number >= 1 && number <= boats.size()) {
                return boats.get(number - 1);
            }
        }
        throw new IllegalArgumentException("'" + text + "': there is no boat '" + named + "'; there "
                + (boats.size() == 1 ? "is " : "are 1 to " + boats.size() + ", ")
                + (boats.size() > 3 ? boats.get(0) + " to " + boats.get(boats.size() - 1) : String.join(", ", boats)));
    }
}
