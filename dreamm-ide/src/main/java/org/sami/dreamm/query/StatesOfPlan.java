package org.sami.dreamm.query;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.drawing.states.StateGraph;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;

/**
 * The graph of states of the open plan, searched off the owner's thread when it is asked for, and what is selected in it: a state stands on the net with its tokens, an
 * arrow with what fires. It is forgotten where the plan runs otherwise. All else on the owner's thread.
 */
public final class StatesOfPlan {
    private final WitnessOnNet net;
    private final PlanSearch<PlanStates> search;
    private OptionalInt state = OptionalInt.empty();
    private OptionalInt arrow = OptionalInt.empty();

    /**
     * Adds its command to a window's.
     *
     * @param robots names of the robots with which a plan is searched
     */
    public StatesOfPlan(
            DreammContext context, WitnessOnNet net, Supplier<List<String>> robots, Executor worker, Executor owner) {
        this.net = Objects.requireNonNull(net, "net");
        search = new PlanSearch<>(
                context,
                robots,
                worker,
                owner,
                new PlanSearch.CommandWords("query-graph", "Graph of states, or queries again", "layers", "shift F9"),
                new Graph());
    }

    /** What is drawn; empty while it is searched, or where nobody asks for it. */
    Optional<PlanStates> states() {
        return search.result();
    }

    /** Whether the graph is shown, or will be. */
    boolean isShown() {
        return search.isShown();
    }

    OptionalInt state() {
        return state;
    }

    OptionalInt arrow() {
        return arrow;
    }

    /** What is selected, or how much was found; empty text where the graph is not shown. */
    String words() {
        if (states().isEmpty()) {
            return search.words();
        }
        StateGraph graph = states().orElseThrow().drawing().graph();
        if (state.isPresent()) {
            StateGraph.State shown = graph.states().get(state.getAsInt());
            return "state " + shown.name() + ": " + String.join("; ", shown.marked());
        }
        if (arrow.isPresent()) {
            StateGraph.Arrow fires = graph.arrows().get(arrow.getAsInt());
            return "from state " + fires.from() + " to " + fires.to() + ": " + String.join(", or ", fires.firings());
        }
        return graph.remark();
    }

    /** Shows the tokens of a state on the net. */
    void selectState(int number) {
        states().ifPresent(shown -> {
            state = OptionalInt.of(number);
            arrow = OptionalInt.empty();
            net.show(shown.markings().get(number), Set.of());
            search.changed();
        });
    }

    /** Shows on the net what fires along an arrow, and the tokens afterwards. */
    void selectArrow(int number) {
        states().ifPresent(shown -> {
            state = OptionalInt.empty();
            arrow = OptionalInt.of(number);
            int to = shown.drawing().graph().arrows().get(number).to();
            net.show(shown.markings().get(to), shown.fired().get(number));
            search.changed();
        });
    }

    /** Tells somebody when something else is shown. */
    void addListener(Runnable listener) {
        search.addListener(listener);
    }

    private final class Graph implements PlanSearch.Subject<PlanStates> {
        @Override
        public String begun() {
            return "Searching…";
        }

        @Override
        public PlanStates search(PlanNetRequest request, BooleanSupplier stop) throws PlanNetTooLargeException {
            return PlanStates.of(request, stop);
        }

        @Override
        public String found(PlanStates found) {
            return "";
        }

        @Override
        public String refused(String why) {
            return why;
        }

        @Override
        public void forgotten(boolean wasFound) {
            state = OptionalInt.empty();
            arrow = OptionalInt.empty();
            net.end();
        }
    }
}
