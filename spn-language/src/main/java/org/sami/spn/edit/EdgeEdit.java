package org.sami.spn.edit;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;

/** Changes of the edges of one plan. */
public sealed interface EdgeEdit extends PlanEdit {
    /** Draws an edge from a place to a transition or from a transition to a place; it has no requirement yet. */
    record Connect(String plan, String from, String to, Mode mode) implements EdgeEdit {
        public Connect {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(from, "from");
            Objects.requireNonNull(to, "to");
            Objects.requireNonNull(mode, "mode");
        }

        @Override
        public String label() {
            return "Connect \"" + from + "\" with \"" + to + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            boolean in = before.place(from).isPresent();
            boolean alike =
                    in ? before.place(to).isPresent() : before.transition(to).isPresent();
            if (alike) {
                throw new EditRefusedException("In the plan \"" + plan + "\" " + from + " and " + to + " are both "
                        + (in ? "places" : "transitions") + ": an edge joins a place and a transition");
            }
            return in
                    ? new ConnectIn(plan, from, to, mode, List.of()).change(before, context)
                    : new ConnectOut(plan, from, to, mode, List.of()).change(before, context);
        }
    }

    /** Draws an edge from a place to a transition. */
    record ConnectIn(String plan, String place, String transition, Mode mode, List<InRequirement> requirements)
            implements EdgeEdit {
        public ConnectIn {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(transition, "transition");
            Objects.requireNonNull(mode, "mode");
            requirements = List.copyOf(requirements);
        }

        @Override
        public String label() {
            return "Connect \"" + place + "\" with \"" + transition + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            Parts.place(before, place);
            Parts.transition(before, transition);
            String id = Parts.freshId(Parts.ids(before), place + "-" + transition);
            return before.withInEdges(
                    Parts.with(before.inEdges(), new InEdge(id, place, transition, mode, requirements)));
        }
    }

    /** Draws an edge from a transition to a place. */
    record ConnectOut(String plan, String transition, String place, Mode mode, List<OutRequirement> requirements)
            implements EdgeEdit {
        public ConnectOut {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(transition, "transition");
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(mode, "mode");
            requirements = List.copyOf(requirements);
        }

        @Override
        public String label() {
            return "Connect \"" + transition + "\" with \"" + place + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            Parts.transition(before, transition);
            Parts.place(before, place);
            String id = Parts.freshId(Parts.ids(before), transition + "-" + place);
            return before.withOutEdges(
                    Parts.with(before.outEdges(), new OutEdge(id, transition, place, mode, requirements)));
        }
    }

    /** Removes the edge from one vertex to another. */
    record Disconnect(String plan, String from, String to) implements EdgeEdit {
        public Disconnect {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(from, "from");
            Objects.requireNonNull(to, "to");
        }

        @Override
        public String label() {
            return "Disconnect \"" + from + "\" from \"" + to + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            Plan after = before.withInEdges(Parts.without(
                            before.inEdges(),
                            e -> e.place().equals(from) && e.transition().equals(to)))
                    .withOutEdges(Parts.without(
                            before.outEdges(),
                            e -> e.transition().equals(from) && e.place().equals(to)));
            if (after.equals(before)) {
                throw new EditRefusedException("In the plan \"" + plan + "\" no edge leads from " + from + " to " + to);
            }
            return after;
        }
    }

    /** Sets what an edge from a place to a transition asks for. */
    record SetInRequirements(String plan, String edge, List<InRequirement> requirements) implements EdgeEdit {
        public SetInRequirements {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(edge, "edge");
            requirements = List.copyOf(requirements);
        }

        @Override
        public String label() {
            return "Change requirements of \"" + edge + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            check(isIn(before, edge), plan, edge, " to a transition");
            return before.withInEdges(
                    Parts.replaced(before.inEdges(), e -> e.id().equals(edge), e -> e.withRequirements(requirements)));
        }
    }

    /** Sets what a firing does with tokens for an edge from a transition to a place. */
    record SetOutRequirements(String plan, String edge, List<OutRequirement> requirements) implements EdgeEdit {
        public SetOutRequirements {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(edge, "edge");
            requirements = List.copyOf(requirements);
        }

        @Override
        public String label() {
            return "Change requirements of \"" + edge + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            check(isOut(before, edge), plan, edge, " to a place");
            return before.withOutEdges(
                    Parts.replaced(before.outEdges(), e -> e.id().equals(edge), e -> e.withRequirements(requirements)));
        }
    }

    /** Locks edges, so that the computation of requirements leaves them as they are (thesis 5.1.1), or unlocks them. */
    record SetLocked(String plan, Set<String> edges, boolean locked) implements EdgeEdit {
        public SetLocked {
            Objects.requireNonNull(plan, "plan");
            edges = Collections.unmodifiableSet(new LinkedHashSet<>(edges));
        }

        @Override
        public String label() {
            return (locked ? "Lock " : "Unlock ") + RemoveElements.inWords(edges);
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            for (String edge : edges) {
                check(isIn(before, edge) || isOut(before, edge), plan, edge, "");
            }
            return before.withInEdges(
                            Parts.replaced(before.inEdges(), e -> edges.contains(e.id()), e -> e.withLocked(locked)))
                    .withOutEdges(
                            Parts.replaced(before.outEdges(), e -> edges.contains(e.id()), e -> e.withLocked(locked)));
        }
    }

    private static boolean isIn(Plan plan, String edge) {
        return plan.inEdges().stream().anyMatch(e -> e.id().equals(edge));
    }

    private static boolean isOut(Plan plan, String edge) {
        return plan.outEdges().stream().anyMatch(e -> e.id().equals(edge));
    }

    private static void check(boolean known, String plan, String edge, String way) throws EditRefusedException {
        if (!known) {
            throw new EditRefusedException("The plan \"" + plan + "\" has no edge " + edge + way);
        }
    }
}
