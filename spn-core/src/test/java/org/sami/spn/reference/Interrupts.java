package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;

/** Interrupts: what the operator presses, and for whom (R-INT-1 to R-INT-4). */
final class Interrupts {
    private final World world;
    private final Attention attention;
    private final Roles roles;

    Interrupts(World world, Attention attention, Roles roles) {
        this.world = world;
        this.attention = attention;
        this.roles = roles;
    }

    /** Presses a button by its name, in one mission or in all that offer it. */
    void press(Input.Interrupt press) {
        List<Mission> offering = press.mission() == Ids.NONE
                ? List.copyOf(world.missions)
                : world.mission(press.mission()).stream().toList();
        boolean offered = false;
        for (Mission m : offering) {
            if (m.reacts()) {
                boolean named = pressNamed(m, press);
                boolean places = pressPlaces(m, press);
                offered = offered || named || places;
            }
        }
        if (!offered) {
            world.note(NoteKind.INTERRUPT_REFUSED, press.mission(), press.name());
        }
    }

    /** Presses the button of a named interrupt (R-INT-1). */
    private boolean pressNamed(Mission m, Input.Interrupt press) {
        Value name = new TextValue(press.name());
        Set<String> types = new LinkedHashSet<>();
        for (Transition t : m.plan.transitions()) {
            for (InputEventSpec event : t.inputs()) {
                if (world.eventType(event.type()).role() == EventRole.INTERRUPT
                        && name.equals(event.fields().get("interruptName"))) {
                    types.add(event.type());
                }
            }
        }
        types.forEach(type -> attention.receive(
                new Occurrence(type, m.id, Ids.NONE, press.proxies(), List.of(), Map.of("interruptName", name))));
        return !types.isEmpty();
    }

    /** Presses the buttons of interrupt places (R-INT-2). */
    private boolean pressPlaces(Mission m, Input.Interrupt press) {
        boolean asked = false;
        boolean offered = false;
        for (Activation a : buttons(m, press.name())) {
            boolean forBoats = world.eventType(a.type()).role() == EventRole.PROXY_INTERRUPT;
            offered = true;
            if (!forBoats) {
                pressed(a, List.of());
            } else if (!press.proxies().isEmpty()) {
                pressed(a, press.proxies());
            } else if (!asked) {
                List<String> boats = candidates(m, a);
                if (boats.isEmpty()) {
                    world.note(NoteKind.INTERRUPT_REFUSED, m.id, press.name());
                } else {
                    roles.questions.askWhom(m, press.name(), boats);
                    asked = true;
                }
            }
        }
        return offered;
    }

    private List<Activation> buttons(Mission m, String name) {
        List<Activation> buttons = new ArrayList<>();
        for (Visit visit : m.visits) {
            for (Activation a : visit.activations) {
                EventRole role = world.eventType(a.type()).role();
                boolean isButton = role == EventRole.GENERAL_INTERRUPT || role == EventRole.PROXY_INTERRUPT;
                if (isButton && a.value("interruptName").equals(Optional.of(new TextValue(name)))) {
                    buttons.add(a);
                }
            }
        }
        buttons.sort(Comparator.comparingLong(Activation::id));
        return buttons;
    }

    private void pressed(Activation a, List<String> proxies) {
        boolean forBoats = world.eventType(a.type()).role() == EventRole.PROXY_INTERRUPT;
        String type = typeOf(forBoats ? EventRole.PROXY_INTERRUPT_RECEIVED : EventRole.GENERAL_INTERRUPT_RECEIVED);
        Map<String, Value> values =
                Map.of("interruptName", a.value("interruptName").orElseThrow());
        attention.receive(Occurrence.answer(type, a, proxies, List.of(), values));
    }

    /** The boats in the other in places of the transitions that the press can fire. */
    private List<String> candidates(Mission m, Activation a) {
        Place button = world.visitOfActivation.get(a.id()).place;
        Set<String> boats = new LinkedHashSet<>();
        for (Transition t : m.outTransitions(button)) {
            boolean takesThem = t.inputs().stream()
                    .anyMatch(i -> world.eventType(i.type()).role() == EventRole.PROXY_INTERRUPT_RECEIVED);
            if (takesThem) {
                for (Place place : World.others(m.inPlaces(t), button)) {
                    m.tokensIn(place).stream()
                            .filter(c -> c.token instanceof Token.Proxy)
                            .forEach(c -> boats.add(((Token.Proxy) c.token).proxy()));
                }
            }
        }
        return List.copyOf(boats);
    }

    /** Presses the buttons of interrupt places for the boats that the operator chose. */
    void press(Mission m, String name, List<String> proxies) {
        buttons(m, name).stream()
                .filter(a -> world.eventType(a.type()).role() == EventRole.PROXY_INTERRUPT)
                .forEach(a -> pressed(a, proxies));
    }

    private String typeOf(EventRole role) {
        return world.vocabulary.eventWithRole(role).orElseThrow().name();
    }
}
