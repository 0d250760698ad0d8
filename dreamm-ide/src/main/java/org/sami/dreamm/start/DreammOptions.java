package org.sami.dreamm.start;

import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.profile.Profile;
import org.sami.palette.Theme;

/**
 * How a window is to be opened.
 *
 * @param open a plan's id, or the file or folder of a project; empty = the library of the domain
 * @param domain folder of a domain, or name of one that ships; empty = the boats' domain, which ships
 * @param theme from now on; empty = as it was
 * @param scale in percent, from now on; empty = as it was
 * @param learn whether the course is opened
 */
public record DreammOptions(
        Optional<String> open,
        Optional<Path> domain,
        Profile profile,
        Optional<Theme> theme,
        Optional<Integer> scale,
        LearnOptions learn) {
    public DreammOptions {
        Objects.requireNonNull(open, "open");
        Objects.requireNonNull(domain, "domain");
        Objects.requireNonNull(profile, "profile");
        Objects.requireNonNull(theme, "theme");
        Objects.requireNonNull(scale, "scale");
        Objects.requireNonNull(learn, "learn");
    }

    /** Without the course. */
    public DreammOptions(
            Optional<String> open,
            Optional<Path> domain,
            Profile profile,
            Optional<Theme> theme,
            Optional<Integer> scale) {
        this(open, domain, profile, theme, scale, LearnOptions.NONE);
    }
}
