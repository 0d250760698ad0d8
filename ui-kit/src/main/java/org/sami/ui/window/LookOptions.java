package org.sami.ui.window;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.palette.Theme;
import org.sami.ui.look.Look;
import picocli.CommandLine.Option;

/** The options of a command line that choose how a window looks; a command takes them as a mixin. */
public final class LookOptions {
    @Option(names = "--theme", paramLabel = "light|dark|sun", description = "The theme, from now on.")
    private @Nullable String theme;

    @Option(
            names = "--scale",
            paramLabel = "80..200",
            description = "The scale of all text and marks in percent, from now on.")
    private @Nullable Integer scale;

    /**
     * The theme; empty = as it was.
     *
     * @throws IllegalArgumentException if there is no such theme
     */
    public Optional<Theme> theme() {
        return Optional.ofNullable(theme)
                .map(id -> Theme.of(id)
                        .orElseThrow(() -> new IllegalArgumentException(
                                "--theme: there is no theme " + id + "; there are light, dark, sun")));
    }

    /**
     * The scale in percent; empty = as it was.
     *
     * @throws IllegalArgumentException if it is out of range
     */
    public Optional<Integer> scale() {
        if (scale != null && (scale < Look.LEAST || scale > Look.MOST)) {
            throw new IllegalArgumentException(
                    "--scale: " + scale + " is not from " + Look.LEAST + " to " + Look.MOST + " percent");
        }
        return Optional.ofNullable(scale);
    }
}
