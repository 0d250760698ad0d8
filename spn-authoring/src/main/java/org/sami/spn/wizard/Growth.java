package org.sami.spn.wizard;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.edit.FreshIds;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Gathering;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Draws vertices, edges and events into a plan, as flexible sequences say. Edges get no requirement here. */
final class Growth {
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;
    private final Mode mode;
    private final FreshIds ids;
    private final Set<String> grown = new HashSet<>();
    private Gathering gathering = Gathering.WAIT_FOR_ALL;
    private Plan plan;

    Growth(Plan plan, Vocabulary vocabulary, AuthoringLibrary library, Mode mode) {
        this.plan = plan;
        this.vocabulary = vocabulary;
        this.library = library;
        this.mode = mode;
        this.ids = new FreshIds(plan);
    }

    Plan plan() {
        return plan;
    }

    /** Says how what is drawn goes on where robots answer one by one. */
    void gather(Gathering how) {
        gathering = how;
    }

    /** A new place, called by what happens there. */
    String place(String name, Optional<LayoutPoint> at) {
        String id = ids.take(name.isEmpty() ? "place" : FreshIds.ofWords(name));
        boolean first = plan.places().isEmpty();
        List<Place> places = new ArrayList<>(plan.places());
        places.add(new Place(id, name, first, false, false, mode, List.of(), List.of(), List.of()));
        plan = laidOut(plan.withPlaces(places), id, at);
        return id;
    }

    String transition(String name, Optional<LayoutPoint> at) {
        String id = ids.take(name.isEmpty() ? "transition" : FreshIds.ofWords(name));
        List<Transition> transitions = new ArrayList<>(plan.transitions());
        transitions.add(new Transition(id, name, mode, WaitFor.EACH, List.of()));
        plan = laidOut(plan.withTransitions(transitions), id, at);
        return id;
    }

    private static Plan laidOut(Plan plan, String vertex, Optional<LayoutPoint> at) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        at.ifPresent(point -> layout.put(vertex, point));
        return plan.withLayout(layout);
    }

    /** Where a vertex behind another is drawn. */
    Optional<LayoutPoint> behind(String vertex) {
        return FreeSpace.behind(plan, vertex);
    }

    void connect(String place, String transition) {
        List<InEdge> edges = new ArrayList<>(plan.inEdges());
        edges.add(new InEdge(ids.take(place + "-" + transition), place, transition, mode, List.of()));
        plan = plan.withInEdges(edges);
    }

    void connectOut(String transition, String place) {
        List<OutEdge> edges = new ArrayList<>(plan.outEdges());
        edges.add(new OutEdge(ids.take(transition + "-" + place), transition, place, mode, List.of()));
        plan = plan.withOutEdges(edges);
    }

    /** Puts an output event on a place. */
    void output(String place, EventType type) {
        OutputEventSpec event =
                new OutputEventSpec(ids.take(place + "." + type.name()), type.name(), Map.of(), Map.of(), List.of());
        plan = plan.withPlaces(plan.places().stream()
                .map(p -> p.id().equals(place) ? p.withOutputs(with(p.outputs(), event)) : p)
                .toList());
    }

    /** Puts an input event on a transition. */
    void input(String transition, EventType type) {
        InputEventSpec event = new InputEventSpec(
                ids.take(transition + "." + type.name()), type.name(), Map.of(), Map.of(), List.of());
        plan = plan.withTransitions(plan.transitions().stream()
                .map(t -> t.id().equals(transition) ? t.withInputs(with(t.inputs(), event)) : t)
                .toList());
    }

    /** Has a place run a plan. */
    void subMission(String place, String runs) {
        SubMissionSpec sub = new SubMissionSpec(ids.take(place + ".sub"), runs, false, Map.of(), Map.of());
        plan = plan.withPlaces(plan.places().stream()
                .map(p -> p.id().equals(place) ? p.withSubMissions(with(p.subMissions(), sub)) : p)
                .toList());
    }

    /** Draws what leads out of a place after an output event was put on it. */
    void followOutput(String place, String event) {
        if (!grown.add(event)) {
            return; // a sequence that leads back to itself ends here
        }
        for (String answer :
                library.ofOutput(event).map(Sequence.OfOutput::inputs).orElse(List.of())) {
            vocabulary.event(answer).filter(a -> !awaited(place, answer)).ifPresent(type -> {
                String transition = transition(type.label(), behind(place));
                connect(place, transition);
                input(transition, type);
                followInput(transition, answer);
            });
        }
        grown.remove(event);
    }

    /** Draws what leads out of a transition after an input event was put on it. */
    void followInput(String transition, String event) {
        Optional<Sequence.OfInput> sequence = library.ofInput(event);
        if (sequence.isEmpty() || !grown.add(event)) {
            return;
        }
        if (plan.transition(transition).orElseThrow().inputs().size() == 1) {
            boolean each = gathering != Gathering.WAIT_FOR_ALL;
            waitFor(transition, each ? WaitFor.EACH : sequence.get().waitFor());
        }
        for (String output : sequence.get().outputs()) {
            vocabulary.event(output).ifPresent(type -> {
                String place = place(type.label(), behind(transition));
                connectOut(transition, place);
                output(place, type);
                followOutput(place, output);
            });
        }
        if (plan.outEdgesOf(transition).isEmpty()) {
            connectOut(transition, place("", behind(transition)));
        }
        grown.remove(event);
    }

    private void waitFor(String transition, WaitFor waitFor) {
        plan = plan.withTransitions(plan.transitions().stream()
                .map(t -> t.id().equals(transition) ? t.withWaitFor(waitFor) : t)
                .toList());
    }

    private boolean awaited(String place, String answer) {
        return plan.inEdges().stream()
                .filter(e -> e.place().equals(place))
                .flatMap(e -> plan.transition(e.transition()).stream())
                .flatMap(t -> t.inputs().stream())
                .anyMatch(i -> i.type().equals(answer));
    }

    private static <T> List<T> with(List<T> list, T more) {
        List<T> longer = new ArrayList<>(list);
        longer.add(more);
        return longer;
    }
}
