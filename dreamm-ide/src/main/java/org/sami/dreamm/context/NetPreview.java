package org.sami.dreamm.context;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.picture.net.NetChange;
import org.sami.spn.model.Plan;

/** What the open plan would be after an edit that is not made yet: the model view shows it in the plan's place. On the event thread. */
public final class NetPreview {
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Optional<Shown> shown = Optional.empty();

    /**
     * What is shown.
     *
     * @param plan the open plan as it would be
     * @param changes what would be new or other, by the ids of elements
     */
    public record Shown(Plan plan, Map<String, NetChange> changes) {
        public Shown {
            Objects.requireNonNull(plan, "plan");
            changes = Map.copyOf(changes);
        }
    }

    /** What is shown now; empty where nothing is previewed. */
    public Optional<Shown> shown() {
        return shown;
    }

    /** Shows a plan. */
    public void show(Plan plan, Map<String, NetChange> changes) {
        shown = Optional.of(new Shown(plan, changes));
        listeners.forEach(Runnable::run);
    }

    /** Shows the plan as it is. */
    public void clear() {
        if (shown.isPresent()) {
            shown = Optional.empty();
            listeners.forEach(Runnable::run);
        }
    }

    /** Adds somebody who shows it. */
    public void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
