package org.sami.ui.look;

import com.formdev.flatlaf.FlatLaf;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/** The looks that a window can have. */
public enum Theme {
    /** Dark text on light grey, for rooms. */
    LIGHT("Light", LightLaf::new),
    /** Light text on dark grey, for dusk. */
    DARK("Dark", DarkLaf::new),
    /** For a screen in the sun: text of at least 7:1, marks of at least 4.5:1, heavy lines. */
    SUN("Sun", SunLaf::new);

    private final String title;
    private final Supplier<FlatLaf> laf;

    Theme(String title, Supplier<FlatLaf> laf) {
        this.title = title;
        this.laf = laf;
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

    FlatLaf laf() {
        return laf.get();
    }
}
