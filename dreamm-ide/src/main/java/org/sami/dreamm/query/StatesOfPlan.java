package org.sami.dreamm.query;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.tryout.NetChanges;
import org.sami.spn.drawing.states.StateGraph;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.ui.command.Command;

/**
 * The graph of states of the open plan, searched off the owner's thread when it is asked for, and what is selected in it: a state stands on the net with its tokens, an
 * arrow with what fires. It is forgotten where the plan runs otherwise. All else on the owner's thread.
 */
public final class StatesOfPlan {
    private final DreammContext context;
    private final WitnessOnNet net;
    private final Supplier<List<String>> robots;
    private final Executor worker;
    private final Executor owner;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Optional<PlanStates> states = Optional.empty();
    private Optional<AtomicBoolean> searching = Optional.empty();
    private OptionalInt state = OptionalInt.empty();
    private OptionalInt arrow = OptionalInt.empty();
    private String message = "";

    /**
     * Adds its command to a window's.
     *
     * @param robots names of the robots with which a plan is searched
     */
    public StatesOfPlan(
            DreammContext context, WitnessOnNet net, Supplier<List<String>> robots, Executor worker, Executor owner) {
        this.context = Objects.requireNonNull(context, "context");
        this.net = Objects.requireNonNull(net, "net");
        this.robots = Objects.requireNonNull(robots, "robots");
        this.worker = Objects.requireNonNull(worker, "worker");
        this.owner = Objects.requireNonNull(owner, "owner");
        context.commands()
                .add(new Command("query-graph", "Graph of states, or queries again", this::toggle)
                        .withIcon("layers")
                        .withKey("shift F9")
                        .unless(() -> context.editor().planId().isPresent()
                                ? Optional.empty()
                                : Optional.of("no plan is open")));
        context.document().addListener((DocumentChange change) -> {
            if (NetChanges.in(change)) {
                forget();
            }
        });
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                forget();
            }
        });
    }

    /** What is drawn; empty while it is searched, or where nobody asks for it. */
    Optional<PlanStates> states() {
        return states;
    }

    /** Whether the graph is shown, or will be. */
    boolean isShown() {
        return states.isPresent() || searching.isPresent();
    }

    OptionalInt state() {
        return state;
    }

    OptionalInt arrow() {
        return arrow;
    }

    /** What is selected, or how much was found; empty text where the graph is not shown. */
    String words() {
        if (states.isEmpty()) {
            return message;
        }
        StateGraph graph = states.get().drawing().graph();
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

    private void toggle() {
        if (isShown()) {
            forget();
            return;
        }
        AtomicBoolean stop = new AtomicBoolean();
        searching = Optional.of(stop);
        message = "Searching…";
        PlanNetRequest request = new PlanNetRequest(
                context.document().project(),
                context.document().vocabulary(),
                context.editor().planId().orElseThrow(),
                robots.get());
        worker.execute(() -> search(request, stop));
        changed();
    }

    private void search(PlanNetRequest request, AtomicBoolean stop) {
        try {
            PlanStates found = PlanStates.of(request, stop::get);
            owner.execute(() -> found(Optional.of(found), "", stop));
        } catch (PlanNetTooLargeException | IllegalArgumentException | CancellationException refused) {
            owner.execute(() -> found(Optional.empty(), String.valueOf(refused.getMessage()), stop));
        }
    }

    private void found(Optional<PlanStates> found, String why, AtomicBoolean stop) {
        if (!stop.get()) {
            searching = Optional.empty();
            states = found;
            message = why;
            changed();
        }
    }

    private void forget() {
        searching.ifPresent(stop -> stop.set(true));
        boolean wasShown = isShown();
        searching = Optional.empty();
        states = Optional.empty();
        state = OptionalInt.empty();
        arrow = OptionalInt.empty();
        message = "";
        if (wasShown) {
            net.end();
            changed();
        }
    }

    /** Shows the tokens of a state on the net. */
    void selectState(int number) {
        states.ifPresent(shown -> {
            state = OptionalInt.of(number);
            arrow = OptionalInt.empty();
            net.show(shown.markings().get(number), Set.of());
            changed();
        });
    }

    /** Shows on the net what fires along an arrow, and the tokens afterwards. */
    void selectArrow(int number) {
        states.ifPresent(shown -> {
            state = OptionalInt.empty();
            arrow = OptionalInt.of(number);
            int to = shown.drawing().graph().arrows().get(number).to();
            net.show(shown.markings().get(to), shown.fired().get(number));
            changed();
        });
    }

    /** Tells somebody when something else is shown. */
    void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }
}
