package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongFunction;
import java.util.function.LongSupplier;
import org.sami.crw.manipulation.ManipulationLimit;
import org.sami.crw.manipulation.ManipulationPolicy;
import org.sami.crw.manipulation.Ruling;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.markup.MarkedEvent;

/**
 * The events whose markup changes the map now: output events of present visits, and the last input event of each transition, until its mission ends.
 * Whether an event may change the map is decided once, when it arrives (meta-markup, thesis 5.3). For the owner's thread.
 */
public final class MapEvents {
    private static final String COMPONENT = "map";
    private static final String MESSAGE = "DisplayMessage";

    private final ManipulationPolicy policy;
    private final LongFunction<String> missions;
    private final Map<String, MarkedEvent> inForce = new LinkedHashMap<>();
    // by event: a newer one takes the place of an older one
    private final Map<String, Later> waiting = new LinkedHashMap<>();
    private String heldBack = "";

    private record Later(MarkedEvent event, long atMillis) {}

    /**
     * None came.
     *
     * @param missions names a mission
     */
    public MapEvents(LongSupplier nowMillis, LongFunction<String> missions) {
        policy = new ManipulationPolicy(nowMillis);
        this.missions = missions;
    }

    public void touched() {
        policy.touched(COMPONENT);
    }

    public void focus(boolean on) {
        policy.focus(COMPONENT, on);
    }

    /** An event came. Gives it where it may change the map now. */
    public Optional<MarkedEvent> came(MarkedEvent event) {
        if (!concernsMap(event)) {
            return Optional.empty();
        }
        Ruling ruling = policy.rule(source(event), limits(event));
        if (ruling.kind() == Ruling.Kind.LATER) {
            waiting.put(event.event(), new Later(event, ruling.untilMillis()));
        }
        return ruled(event, ruling);
    }

    private Optional<MarkedEvent> ruled(MarkedEvent event, Ruling ruling) {
        if (ruling.kind() == Ruling.Kind.NOW) {
            inForce.remove(key(event)); // the newest stands last
            inForce.put(key(event), event);
            heldBack = "";
            return Optional.of(event);
        }
        String what = ruling.kind() == Ruling.Kind.LATER ? " changes the map later: " : " does not change the map: ";
        heldBack = event.words(missions) + what + ruling.why();
        return Optional.empty();
    }

    /** Gives the events whose waiting time is up and that may change the map now. */
    public List<MarkedEvent> due(long nowMillis) {
        List<MarkedEvent> due = new ArrayList<>();
        for (Later later : List.copyOf(waiting.values())) {
            if (later.atMillis() <= nowMillis) {
                waiting.remove(later.event().event());
                Ruling ruling = policy.due(source(later.event()), limits(later.event()));
                ruled(later.event(), ruling).ifPresent(due::add);
            }
        }
        return due;
    }

    public boolean hasWaiting() {
        return !waiting.isEmpty();
    }

    /** The visit of an activation is over. Gives whether that changes something. */
    public boolean ended(long activation) {
        waiting.values().removeIf(later -> later.event().activation() == activation);
        return inForce.remove(key(activation)) != null;
    }

    /** A mission is over; a change that waits is made all the same, as it was news. Gives whether that changes something. */
    public boolean missionEnded(long mission) {
        boolean changed = false;
        for (Iterator<MarkedEvent> events = inForce.values().iterator(); events.hasNext(); ) {
            if (events.next().mission() == mission) {
                events.remove();
                changed = true;
            }
        }
        return changed;
    }

    /** The events in force, oldest first. */
    public Collection<MarkedEvent> inForce() {
        return inForce.values();
    }

    /** The last change that was not made, or is made later, and why; empty text for none. */
    public String heldBack() {
        return heldBack;
    }

    /** What a message is about is pointed at when the operator asks for it (thesis 6.3.3), not when it comes. */
    private static boolean concernsMap(MarkedEvent event) {
        MapRelevance relevance = event.relevance(List.of());
        return relevance.area().isPresent()
                || relevance.information().isPresent()
                || (relevance.boats().isPresent() && !event.type().equals(MESSAGE));
    }

    private static ManipulationPolicy.Source source(MarkedEvent event) {
        return new ManipulationPolicy.Source(COMPONENT, event.event());
    }

    private static Set<ManipulationLimit> limits(MarkedEvent event) {
        return ManipulationLimit.of(event.reader());
    }

    private static String key(MarkedEvent event) {
        return event.isOutput() ? key(event.activation()) : event.mission() + " " + event.event();
    }

    private static String key(long activation) {
        return "a" + activation;
    }
}
