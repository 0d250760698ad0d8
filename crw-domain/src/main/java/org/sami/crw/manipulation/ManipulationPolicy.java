package org.sami.crw.manipulation;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.LongSupplier;

/**
 * Rules whether an event may change a component of a window, by the limits that its markup sets, by when it changed the component last
 * and by what the operator does there (thesis 5.3). An event without limits always may. For one thread.
 */
public final class ManipulationPolicy {
    /** How long after a change of its own an event that limits its frequency waits; chosen by the GUI's designer (thesis 5.3). */
    public static final long COOLDOWN_MILLIS = 10_000;

    /** How long the operator has a component for himself after he used it, with timed suppress. */
    public static final long IN_USE_MILLIS = 10_000;

    private final LongSupplier nowMillis;
    private final Map<String, Long> touched = new HashMap<>();
    private final Set<String> focused = new HashSet<>();
    private final Map<Source, Long> changed = new HashMap<>();

    /**
     * Who wants to change what.
     *
     * @param component name of what is changed, such as {@code map}
     * @param event names the event of the plan, the same for all its missions and visits
     */
    public record Source(String component, String event) {
        public Source {
            Objects.requireNonNull(component, "component");
            Objects.requireNonNull(event, "event");
        }
    }

    /** A policy for components that nobody has used. */
    public ManipulationPolicy(LongSupplier nowMillis) {
        this.nowMillis = Objects.requireNonNull(nowMillis, "nowMillis");
    }

    /** The operator has used a component: moved it, typed or pressed there. */
    public void touched(String component) {
        touched.put(component, nowMillis.getAsLong());
    }

    /** The operator's focus has come to a component, or left it. */
    public void focus(String component, boolean on) {
        if (on) {
            focused.add(component);
        } else {
            focused.remove(component);
        }
    }

    /**
     * Rules about a change. One that may be made now counts as made; one that waits is asked again when its time has come
     * ({@link #due}).
     */
    public Ruling rule(Source source, Set<ManipulationLimit> limits) {
        Ruling component = component(source, limits);
        if (component.kind() != Ruling.Kind.NOW) {
            return component;
        }
        long now = nowMillis.getAsLong();
        Long before = changed.get(source);
        long free = before == null ? now : before + COOLDOWN_MILLIS;
        if (before != null && free > now && limits.contains(ManipulationLimit.SUPPRESS)) {
            return new Ruling(
                    Ruling.Kind.DROPPED,
                    0,
                    "its event changed the " + source.component() + " " + (now - before) / 1000 + " s ago");
        }
        if (free > now && limits.contains(ManipulationLimit.TIMED_BATCH)) {
            return new Ruling(Ruling.Kind.LATER, free, "its event changed the " + source.component() + " just now");
        }
        changed.put(source, now);
        return Ruling.NOW;
    }

    /** Rules about a change whose waiting time is up. */
    public Ruling due(Source source, Set<ManipulationLimit> limits) {
        Ruling ruling = component(source, limits);
        if (ruling.kind() == Ruling.Kind.NOW) {
            changed.put(source, nowMillis.getAsLong());
        }
        return ruling;
    }

    private Ruling component(Source source, Set<ManipulationLimit> limits) {
        if (limits.contains(ManipulationLimit.FOCUS_SUPPRESS) && focused.contains(source.component())) {
            return dropped("the operator works with the " + source.component());
        }
        Long used = touched.get(source.component());
        boolean inUse = used != null && nowMillis.getAsLong() - used < IN_USE_MILLIS;
        return limits.contains(ManipulationLimit.TIMED_SUPPRESS) && inUse
                ? dropped("the operator used the " + source.component() + " just now")
                : Ruling.NOW;
    }

    private static Ruling dropped(String why) {
        return new Ruling(Ruling.Kind.DROPPED, 0, why);
    }
}
