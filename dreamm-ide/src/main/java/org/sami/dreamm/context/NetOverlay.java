package org.sami.dreamm.context;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetMarking;

/**
 * What lies over the net of the open plan while it is tried or a journal is looked at: tokens, breakpoints, what no test case visits. Who runs
 * the plan puts it here, and the model view shows it. On the event thread.
 */
public final class NetOverlay {
    private final List<Listener> listeners = new CopyOnWriteArrayList<>();
    private Shown shown = Shown.NOTHING;

    /**
     * What is shown.
     *
     * @param why one more line in the tooltip of a vertex, such as why a transition does not fire
     */
    public record Shown(NetMarking marking, NetBadges badges, Function<String, Optional<String>> why) {
        /** Nothing lies over the net. */
        public static final Shown NOTHING = new Shown(NetMarking.EMPTY, NetBadges.NONE, id -> Optional.empty());

        public Shown {
            Objects.requireNonNull(marking, "marking");
            Objects.requireNonNull(badges, "badges");
            Objects.requireNonNull(why, "why");
        }
    }

    /** Hears what is to be shown. */
    public interface Listener {
        /** Something else is shown. */
        void changed();

        /** Transitions have just fired, in order. */
        default void fired(List<String> transitions) {}
    }

    /** What is shown now. */
    public Shown shown() {
        return shown;
    }

    /** Shows this instead. */
    public void show(Shown next) {
        shown = Objects.requireNonNull(next, "next");
        listeners.forEach(Listener::changed);
    }

    /** Lets transitions of the open plan shine, as they have just fired. */
    public void fired(Set<String> transitions) {
        listeners.forEach(listener -> listener.fired(List.copyOf(transitions)));
    }

    /** Adds somebody who shows it. */
    public void addListener(Listener listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
