package org.sami.palette;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** The sets of colours that windows and pictures can have. */
public enum Theme {
    /** Dark text on light grey, for rooms; and for paper. */
    LIGHT("Light"),
    /** Light text on dark grey, for dusk. */
    DARK("Dark"),
    /** For a screen in the sun: text of at least 7:1, marks of at least 4.5:1, heavy lines. */
    SUN("Sun");

    private static volatile Theme inForce = LIGHT;

    private final String title;

    Theme(String title) {
        this.title = title;
    }

    /** What a menu calls it. */
    public String title() {
        return title;
    }

    /** Names it in settings and commands: lower case, stable. */
    public String id() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The theme of an id. */
    public static Optional<Theme> of(String id) {
        return Stream.of(values()).filter(theme -> theme.id().equals(id)).findFirst();
    }

    /** The theme of this process's windows; {@link #LIGHT} where there are none. */
    public static Theme inForce() {
        return inForce;
    }

    /** Makes this the theme of the process's windows. Whoever changes their look calls it; pictures name their theme instead. */
    public void putInForce() {
        inForce = this;
    }
}
