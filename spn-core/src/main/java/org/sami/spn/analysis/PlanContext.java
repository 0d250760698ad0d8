package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** A plan with what surrounds it, and the questions that checks ask about neighbours and places in the document. */
final class PlanContext {
    private final Project project;
    private final Vocabulary vocabulary;
    private final Plan plan;
    private final String pointer;
    private final List<PlacedOutput> outputs = new ArrayList<>();
    private final List<PlacedInput> inputs = new ArrayList<>();

    PlanContext(Project project, Vocabulary vocabulary, Plan plan) {
        this.project = project;
        this.vocabulary = vocabulary;
        this.plan = plan;
        this.pointer = "/plans/" + project.plans().indexOf(plan);
        for (Place place : plan.places()) {
            for (int i = 0; i < place.outputs().size(); i++) {
                OutputEventSpec spec = place.outputs().get(i);
                String where = at(place) + "/outputs/" + i;
                vocabulary
                        .event(spec.type())
                        .ifPresent(type -> outputs.add(new PlacedOutput(place, spec, type, where)));
            }
        }
        for (Transition transition : plan.transitions()) {
            for (int i = 0; i < transition.inputs().size(); i++) {
                InputEventSpec spec = transition.inputs().get(i);
                String where = at(transition) + "/inputs/" + i;
                vocabulary
                        .event(spec.type())
                        .ifPresent(type -> inputs.add(new PlacedInput(transition, spec, type, where)));
            }
        }
    }

    Project project() {
        return project;
    }

    Vocabulary vocabulary() {
        return vocabulary;
    }

    Plan plan() {
        return plan;
    }

    String pointer() {
        return pointer;
    }

    /** Output events whose type is known, in document order. */
    List<PlacedOutput> outputs() {
        return outputs;
    }

    /** Input events whose type is known, in document order. */
    List<PlacedInput> inputs() {
        return inputs;
    }

    List<PlacedInput> inputsOf(Transition transition) {
        return inputs.stream().filter(i -> i.transition().equals(transition)).toList();
    }

    List<PlacedOutput> outputsOf(Place place) {
        return outputs.stream().filter(o -> o.place().equals(place)).toList();
    }

    List<InEdge> inEdges(Transition transition) {
        return plan.inEdgesOf(transition.id());
    }

    List<OutEdge> outEdges(Transition transition) {
        return plan.outEdgesOf(transition.id());
    }

    List<OutEdge> edgesInto(Place place) {
        return plan.outEdges().stream()
                .filter(e -> e.place().equals(place.id()))
                .toList();
    }

    List<Place> inPlaces(Transition transition) {
        return inEdges(transition).stream()
                .map(e -> plan.place(e.place()))
                .flatMap(Optional::stream)
                .toList();
    }

    List<Place> outPlaces(Transition transition) {
        return outEdges(transition).stream()
                .map(e -> plan.place(e.place()))
                .flatMap(Optional::stream)
                .toList();
    }

    List<Transition> outTransitions(Place place) {
        return plan.inEdges().stream()
                .filter(e -> e.place().equals(place.id()))
                .map(e -> plan.transition(e.transition()))
                .flatMap(Optional::stream)
                .toList();
    }

    Optional<Plan> child(SubMissionSpec subMission) {
        return project.plan(subMission.plan());
    }

    /** Plans that run this one as a sub-mission. */
    List<Plan> parents() {
        return project.plans().stream()
                .filter(p -> p.places().stream()
                        .flatMap(place -> place.subMissions().stream())
                        .anyMatch(s -> s.plan().equals(plan.id())))
                .toList();
    }

    String at(Place place) {
        return pointer + "/places/" + plan.places().indexOf(place);
    }

    String at(Transition transition) {
        return pointer + "/transitions/" + plan.transitions().indexOf(transition);
    }

    String at(InEdge edge) {
        return pointer + "/inEdges/" + plan.inEdges().indexOf(edge);
    }

    String at(OutEdge edge) {
        return pointer + "/outEdges/" + plan.outEdges().indexOf(edge);
    }

    /** A place as messages speak of it. */
    static String name(Place place) {
        return "place \"" + (place.name().isEmpty() ? place.id() : place.name()) + "\"";
    }

    /** A transition as messages speak of it. */
    static String name(Transition transition) {
        return "transition \"" + (transition.name().isEmpty() ? transition.id() : transition.name()) + "\"";
    }

    /** An output event of a known type, where it stands. */
    record PlacedOutput(Place place, OutputEventSpec spec, EventType type, String pointer) {}

    /** An input event of a known type, where it stands. */
    record PlacedInput(Transition transition, InputEventSpec spec, EventType type, String pointer) {}
}
