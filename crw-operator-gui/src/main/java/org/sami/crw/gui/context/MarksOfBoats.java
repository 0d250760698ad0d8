package org.sami.crw.gui.context;

import java.util.ArrayList;
import java.util.List;
import org.sami.crw.session.JoinOrder;
import org.sami.palette.ProxyMarks;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.ui.EventThread;

/**
 * Gives boats their marks in the {@link JoinOrder} of the session's journal, so that a boat has the same colour in a session, in its replay and in its report. Follows
 * the engine on its thread, and gives marks on the event thread.
 */
public final class MarksOfBoats implements HostListener {
    private final ProxyMarks marks;
    private final JoinOrder order = new JoinOrder(); // on the event thread, as are the two below
    private final List<Runnable> held = new ArrayList<>(); // steps that came before the state did
    private boolean known;

    private MarksOfBoats(ProxyMarks marks) {
        this.marks = marks;
    }

    /** Gives marks to the boats that a session has, and to those that will join. */
    public static void give(ShownSession shown, ProxyMarks marks) {
        MarksOfBoats boats = new MarksOfBoats(marks);
        shown.addListener(boats); // first, so that no step is missed between it and the state
        shown.ask(view -> new Known(view.proxies(), !view.missions().isEmpty())).thenAccept(boats::apply);
    }

    private record Known(List<String> boats, boolean missions) {}

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        if (input instanceof Input.ProxyJoined || effects.stream().anyMatch(Effect.MissionStarted.class::isInstance)) {
            EventThread.later(() -> {
                held.add(() -> order.onStep(input, effects));
                follow();
            });
        }
    }

    /** Follows the steps that were held: a mission's start decides the order of the boats that the state before it names. */
    private void follow() {
        if (known) {
            held.forEach(Runnable::run);
            held.clear();
            order.decided().forEach(marks::give);
        }
    }

    private void apply(Known state) {
        order.join(state.boats());
        if (state.missions()) {
            order.begin();
        }
        known = true;
        follow();
    }
}
