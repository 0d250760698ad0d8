package org.sami.crw.manipulation;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.sami.crw.markup.MarkupReader;

/** A limit that an event sets to its own changes of views (meta-markups, thesis 5.3). */
public enum ManipulationLimit {
    /** Manipulation Frequency, suppress: what comes too soon after the event's last change is left out. */
    SUPPRESS,
    /** Manipulation Frequency, timed batch: what comes too soon waits until the time is up; of several the last is made. */
    TIMED_BATCH,
    /** Manipulation Component, focus suppress: nothing is changed while the operator's focus is on the component. */
    FOCUS_SUPPRESS,
    /** Manipulation Component, timed suppress: nothing is changed for some time after the operator last used the component. */
    TIMED_SUPPRESS;

    /** The limits that an event's markups set. */
    public static Set<ManipulationLimit> of(MarkupReader markups) {
        Set<ManipulationLimit> limits = EnumSet.noneOf(ManipulationLimit.class);
        for (String markup : List.of("ManipulationFrequency", "ManipulationComponent")) {
            markups.constant(markup, "limit", ManipulationLimit.class).ifPresent(limits::add);
        }
        return limits;
    }
}
