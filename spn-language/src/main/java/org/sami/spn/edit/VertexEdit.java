package org.sami.spn.edit;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

/** Changes of places and transitions of one plan. They are removed by {@link RemoveElements} and get other ids by {@link RenameElement}. */
public sealed interface VertexEdit extends PlanEdit {
    /**
     * Adds a place, with its events and sub-missions.
     *
     * @param at where it is drawn; empty leaves that to an automatic layout
     */
    record AddPlace(String plan, Place place, Optional<LayoutPoint> at) implements VertexEdit {
        public AddPlace {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(at, "at");
        }

        /** A blank place. */
        public static AddPlace blank(String plan, String id, Mode mode, LayoutPoint at) {
            Place place = new Place(id, "", false, false, false, mode, List.of(), List.of(), List.of());
            return new AddPlace(plan, place, Optional.of(at));
        }

        @Override
        public String label() {
            return "Add place \"" + place.id() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            return laidOut(before.withPlaces(Parts.with(before.places(), place)), place.id(), at);
        }
    }

    /** Adds a transition, with its input events. */
    record AddTransition(String plan, Transition transition, Optional<LayoutPoint> at) implements VertexEdit {
        public AddTransition {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(transition, "transition");
            Objects.requireNonNull(at, "at");
        }

        /** A blank transition. */
        public static AddTransition blank(String plan, String id, Mode mode, LayoutPoint at) {
            Transition transition = new Transition(id, "", mode, WaitFor.EACH, List.of());
            return new AddTransition(plan, transition, Optional.of(at));
        }

        @Override
        public String label() {
            return "Add transition \"" + transition.id() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) {
            return laidOut(before.withTransitions(Parts.with(before.transitions(), transition)), transition.id(), at);
        }
    }

    /** Moves vertices to other points of the drawing. */
    record MoveVertices(String plan, Map<String, LayoutPoint> to) implements VertexEdit {
        public MoveVertices {
            Objects.requireNonNull(plan, "plan");
            to = Map.copyOf(to);
        }

        @Override
        public String label() {
            return to.size() == 1
                    ? "Move \"" + to.keySet().iterator().next() + "\""
                    : "Move " + to.size() + " vertices";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            Map<String, LayoutPoint> layout = new LinkedHashMap<>(before.layout());
            for (String vertex : to.keySet().stream().sorted().toList()) {
                if (before.place(vertex).isEmpty()) {
                    Parts.transition(before, vertex);
                }
                layout.put(vertex, to.get(vertex));
            }
            return before.withLayout(layout);
        }
    }

    /** Gives a vertex another name for people; its id stays. */
    record NameVertex(String plan, String vertex, String name) implements VertexEdit {
        public NameVertex {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(vertex, "vertex");
            Objects.requireNonNull(name, "name");
        }

        @Override
        public String label() {
            return "Name \"" + vertex + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return before.place(vertex).isPresent()
                    ? Parts.withPlace(before, vertex, p -> p.withName(name))
                    : Parts.withTransition(before, vertex, t -> t.withName(name));
        }
    }

    /** Makes a place the start of its plan, and the only one. */
    record SetStart(String plan, String place) implements VertexEdit {
        public SetStart {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
        }

        @Override
        public String label() {
            return "Start at \"" + place + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            Parts.place(before, place);
            return before.withPlaces(before.places().stream()
                    .map(p -> p.start() == p.id().equals(place) ? p : p.withStart(!p.start()))
                    .toList());
        }
    }

    /**
     * Makes a place an end place, or an ordinary one.
     *
     * @param endsSharedInstance only of an end place
     */
    record SetEnd(String plan, String place, boolean end, boolean endsSharedInstance) implements VertexEdit {
        public SetEnd {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
        }

        @Override
        public String label() {
            return (end ? "End at \"" : "Do not end at \"") + place + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Parts.withPlace(
                    before, place, p -> p.withEnd(end).withEndsSharedInstance(end && endsSharedInstance));
        }
    }

    /** Lets a transition fire for each occurrence, or wait for all. */
    record SetWaitFor(String plan, String transition, WaitFor waitFor) implements VertexEdit {
        public SetWaitFor {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(transition, "transition");
            Objects.requireNonNull(waitFor, "waitFor");
        }

        @Override
        public String label() {
            return (waitFor == WaitFor.ALL ? "Wait for all at \"" : "Fire for each at \"") + transition + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Parts.withTransition(before, transition, t -> t.withWaitFor(waitFor));
        }
    }

    /** Sets the order in which the transitions after a place are looked at; those that are not named follow in the order of edges. */
    record OrderTransitions(String plan, String place, List<String> transitions) implements VertexEdit {
        public OrderTransitions {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
            transitions = List.copyOf(transitions);
        }

        @Override
        public String label() {
            return "Order transitions after \"" + place + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            for (String transition : transitions) {
                Parts.transition(before, transition);
            }
            return Parts.withPlace(before, place, p -> p.withTransitionOrder(transitions));
        }
    }

    private static Plan laidOut(Plan plan, String vertex, Optional<LayoutPoint> at) {
        if (at.isEmpty()) {
            return plan;
        }
        Map<String, LayoutPoint> layout = new LinkedHashMap<>(plan.layout());
        layout.put(vertex, at.get());
        return plan.withLayout(layout);
    }
}
