package org.sami.crw.gui.context;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.sami.palette.IdentityMarks;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.ui.EventThread;

/**
 * Gives boats their marks by what the session's journal has, so that a boat has the same colour in a session and in its replay: those that are there when the first
 * mission starts by name, as they are connected at once and join in any order, those that join later in that order. Hears of the engine on its
 * thread, and gives marks on the event thread.
 */
public final class MarksOfBoats implements HostListener {
    private final IdentityMarks marks;
    private final Set<String> joined =
            new TreeSet<>(); // before the first mission; on the event thread, as what follows
    private boolean begun;

    private MarksOfBoats(IdentityMarks marks) {
        this.marks = marks;
    }

    /** Gives marks to the boats that a session has, and to those that will join. */
    public static void give(ShownSession shown, IdentityMarks marks) {
        MarksOfBoats boats = new MarksOfBoats(marks);
        shown.ask(view -> new Known(view.proxies(), !view.missions().isEmpty()))
                .thenAccept(known -> boats.apply(known.boats(), known.missions()));
        shown.addListener(boats);
    }

    private record Known(List<String> boats, boolean missions) {}

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        boolean starts = effects.stream().anyMatch(Effect.MissionStarted.class::isInstance);
        if (input instanceof Input.ProxyJoined boat) {
            EventThread.later(() -> apply(List.of(boat.proxy()), starts));
        } else if (starts) {
            EventThread.later(() -> apply(List.of(), true));
        }
    }

    private void apply(List<String> boats, boolean starts) {
        if (begun) {
            boats.forEach(marks::give);
            return;
        }
        joined.addAll(boats);
        if (starts) {
            begun = true;
            joined.forEach(marks::give);
        }
    }
}
