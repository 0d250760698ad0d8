package org.sami.crw.service.choice;

import java.util.Locale;

/** How well an algorithm serves a criterion, among the algorithms of its service; later is better. */
public enum Merit {
    FAIR,
    GOOD,
    BEST;

    /** The merit as people say it. */
    public String words() {
        return name().toLowerCase(Locale.ROOT);
    }
}
