package org.sami.crw.gui.context;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Which boats are selected: one for map, boats' list, boat panel and interrupts. On the event thread. */
public final class BoatSelection {
    private final List<Runnable> listeners = new ArrayList<>();
    private Set<String> boats = Set.of();

    /** Selects these and no others. */
    public void select(Collection<String> next) {
        Set<String> wanted = new LinkedHashSet<>(next);
        if (!wanted.equals(boats)) {
            boats = wanted;
            listeners.forEach(Runnable::run);
        }
    }

    /** Of those that are selected, only these stay so: the others are gone. */
    public void retain(Collection<String> known) {
        Set<String> left = new LinkedHashSet<>(boats);
        left.retainAll(known);
        select(left);
    }

    /** The ids of those that are selected, in the order of their selection. */
    public List<String> boats() {
        return List.copyOf(boats);
    }

    /** The boat that the boat panel shows: the first that is selected. */
    public Optional<String> first() {
        return boats.stream().findFirst();
    }

    /** Whether a boat is selected. */
    public boolean contains(String boat) {
        return boats.contains(boat);
    }

    /** Calls a listener when others are selected. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }
}
