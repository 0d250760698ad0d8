package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * What is never kept: interrupts, abort and complete. The transition fires now or refuses (thesis 7.0.2).
 *
 * <p>Implements R-INT-1, R-INT-2, R-INT-3, R-INT-4, R-END-1.
 */
public final class Interrupts {
    private final MissionRules rules;
    /** How many transitions a press has fired. */
    private int taken;

    public Interrupts(MissionRules rules) {
        this.rules = rules;
    }

    /** A pending occurrence is used by a firing. */
    public void taken(PendingOccurrence p) {
        if (p.input.isPress()) {
            taken++;
        }
    }

    /** Removes presses that a transition could not use when it was looked at, and notifies the operator. */
    public void refuseKept(TransitionState t) {
        if (t.pending == 0 || t.mission.ended) {
            return; // with a mission end its pending occurrences
        }
        for (CompiledInput input : t.transition.inputs) {
            if (input.isPress()) {
                for (PendingOccurrence p = t.queues[input.index].first; p != null; p = p.next) {
                    t.remove(p);
                    if (input.role != EventRole.ABORT_RECEIVED && input.role != EventRole.COMPLETE_RECEIVED) {
                        refused(t.mission.id, "'" + t.transition + "' cannot take the interrupt now");
                    }
                }
            }
        }
    }

    private void refused(long mission, String why) {
        rules.note(NoteKind.INTERRUPT_REFUSED, mission, why);
    }

    /** A button is pressed. */
    public void interrupt(Input.Interrupt press) {
        List<MissionState> missions = new ArrayList<>();
        if (press.mission() == Ids.NONE) {
            missions.addAll(rules.state().missions.values());
        } else if (rules.state().missions.containsKey(press.mission())) {
            missions.add(rules.state().missions.get(press.mission()));
        }
        boolean offered = false;
        for (MissionState m : missions) {
            if (m.runs()) {
                offered |= pressNamed(m, press.name(), press.proxies());
                offered |= pressPlaces(m, press.name(), press.proxies());
            }
        }
        if (!offered) {
            refused(press.mission(), "No running mission offers the interrupt '" + press.name() + "' now");
        }
    }

    /** Named interrupt events on transitions (appendix .2.2). */
    private boolean pressNamed(MissionState m, String name, List<String> proxies) {
        for (CompiledTransition t : m.plan.transitions) {
            for (CompiledInput input : t.inputs) {
                if (input.role == EventRole.INTERRUPT && name.equals(nameOf(input))) {
                    Map<String, Value> values = Map.of(Reserved.INTERRUPT_NAME, new TextValue(name));
                    rules.routing.route(new Occurrence(input.spec.type(), m.id, Ids.NONE, proxies, List.of(), values));
                    return true;
                }
            }
        }
        return false;
    }

    public static String nameOf(CompiledInput input) {
        return input.selector == null ? "" : input.selector;
    }

    /** Interrupt places (thesis 7.0.2): the press answers every open activation of that name. */
    private boolean pressPlaces(MissionState m, String name, List<String> proxies) {
        boolean offered = false;
        boolean asked = false;
        for (SentActivation sent : openInterrupts(m, name)) {
            boolean robots = sent.output.role == EventRole.PROXY_INTERRUPT;
            if (robots && proxies.isEmpty()) {
                asked = asked || ask(m, sent, name);
            } else {
                press(sent, robots ? proxies : List.of());
            }
            offered = true;
        }
        return offered;
    }

    /** Asks which robots the press is for; where there is none that it could take, it is refused. */
    private boolean ask(MissionState m, SentActivation sent, String name) {
        List<String> candidates = candidates(sent);
        if (candidates.isEmpty()) {
            refused(m.id, "Nobody is there for the interrupt '" + name + "'");
            return false;
        }
        rules.questions.openInterruptChoice(m, name, candidates);
        return true;
    }

    /** The robots of an interrupt were chosen. */
    public void chosen(MissionState m, String name, List<String> proxies) {
        for (SentActivation sent : openInterrupts(m, name)) {
            if (sent.output.role == EventRole.PROXY_INTERRUPT) {
                press(sent, proxies);
            }
        }
    }

    private void press(SentActivation sent, List<String> proxies) {
        EventRole role = sent.output.role == EventRole.PROXY_INTERRUPT
                ? EventRole.PROXY_INTERRUPT_RECEIVED
                : EventRole.GENERAL_INTERRUPT_RECEIVED;
        String type = rules.project().answerType(sent.output, role);
        Map<String, Value> values = Map.of(Reserved.INTERRUPT_NAME, new TextValue(nameOf(sent)));
        rules.routing.route(Occurrence.answer(type, sent.activation, proxies, List.of(), values));
    }

    private static List<SentActivation> openInterrupts(MissionState m, String name) {
        List<SentActivation> result = new ArrayList<>();
        for (Visit v = m.firstVisit(); v != null; v = v.next) {
            for (SentActivation sent = v.firstSent(); sent != null; sent = sent.next()) {
                if (sent.open && isInterrupt(sent.output.role) && nameOf(sent).equals(name)) {
                    result.add(sent);
                }
            }
        }
        return result;
    }

    public static boolean isInterrupt(EventRole role) {
        return role == EventRole.GENERAL_INTERRUPT || role == EventRole.PROXY_INTERRUPT;
    }

    public static String nameOf(SentActivation sent) {
        return sent.activation
                .value(Reserved.INTERRUPT_NAME)
                .map(CompiledInput::text)
                .orElse("");
    }

    /** The robots that stand in the in places of the transitions that the interrupt's answer is for. */
    private List<String> candidates(SentActivation sent) {
        Set<String> robots = new java.util.LinkedHashSet<>();
        MissionState m = sent.mission();
        for (CompiledTransition t : sent.visit.place.place.outTransitions) {
            for (CompiledInput input : t.inputs) {
                if (input.role == EventRole.PROXY_INTERRUPT_RECEIVED) {
                    for (CompiledPlace place : t.inPlaces) {
                        PlaceState state = m.places[place.index];
                        if (state != null && state != sent.visit.place) {
                            addRobots(state, robots);
                        }
                    }
                }
            }
        }
        return List.copyOf(robots);
    }

    private static void addRobots(PlaceState place, Set<String> robots) {
        for (PlacedToken e = place.first(PlacedToken.PROXY); e != null; e = place.nextOfKind(e)) {
            robots.add(((Token.Proxy) e.token).proxy());
        }
    }

    /** Aborts a mission: a transition of it may intercept, else it ends with all its descendants; its outcome is decided. */
    public void abort(MissionState m) {
        rules.missionEnd.asked(m, Outcome.ABORTED);
        if (!m.ended && !intercepted(m, EventRole.ABORT_RECEIVED)) {
            rules.missionEnd.stop(m, Outcome.ABORTED);
        }
    }

    /** Completes a mission, likewise. */
    public void complete(MissionState m) {
        rules.missionEnd.asked(m, Outcome.COMPLETED);
        if (!m.ended && !intercepted(m, EventRole.COMPLETE_RECEIVED)) {
            rules.missionEnd.stop(m, Outcome.COMPLETED);
        }
    }

    private boolean intercepted(MissionState m, EventRole role) {
        if (!m.runs()) {
            return false;
        }
        int before = taken;
        for (CompiledTransition t : m.plan.transitions) {
            for (CompiledInput input : t.inputs) {
                if (input.role == role && Routing.isAttentive(m, t)) {
                    Occurrence o = new Occurrence(input.spec.type(), m.id, Ids.NONE, List.of(), List.of(), Map.of());
                    TransitionState state = m.transition(t.index);
                    rules.pendings.add(state, rules.pendings.make(state, input, o, List.of(), null, null));
                }
            }
        }
        rules.work.run();
        return taken > before;
    }
}
