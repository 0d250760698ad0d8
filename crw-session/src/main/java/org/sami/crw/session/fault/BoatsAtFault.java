package org.sami.crw.session.fault;

import java.util.Locale;

/** What boats that carry out missions do while the engine or its journal does not work. */
public enum BoatsAtFault {
    /** They keep the places where they are, and go on with their missions as soon as the engine does. */
    HOLD("boats hold their places", "Boats that were under way for missions hold their places"),
    /** They are stopped as by the fleet stop, until the operator releases them. */
    STOP("boats are stopped", "All boats are stopped, as by the fleet stop");

    private final String brief;
    private final String words;

    BoatsAtFault(String brief, String words) {
        this.brief = brief;
        this.words = words;
    }

    /** What boats do then, to be read within a sentence. */
    String brief() {
        return brief;
    }

    /** What boats do then, as a sentence. */
    public String words() {
        return words;
    }

    /** As it is typed. */
    public String typed() {
        return name().toLowerCase(Locale.ROOT);
    }
}
