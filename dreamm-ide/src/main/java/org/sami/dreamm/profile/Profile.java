package org.sami.dreamm.profile;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.ui.command.CommandPolicy;

/**
 * What of the window an author is given (thesis, appendix .4.1). Everything that can be hidden or locked has a stable id in kebab case:
 * commands by their ids, panels as {@code panel-ID}, and what panels offer by ids that begin with the panel's subject. Immutable.
 *
 * <p>A pattern is an id, or the beginning of ids with a star at its end. What is neither hidden nor locked is there in full.
 *
 * @param name what it is called
 * @param hide patterns of what is not shown
 * @param lock patterns of what is shown and cannot be used
 * @param keep patterns of what is there in full although another pattern hides or locks it
 */
public record Profile(String name, List<String> hide, List<String> lock, List<String> keep) implements CommandPolicy {
    /** Everything is there. */
    public static final Profile ALL = new Profile("", List.of(), List.of(), List.of());

    public Profile {
        Objects.requireNonNull(name, "name");
        hide = List.copyOf(hide);
        lock = List.copyOf(lock);
        keep = List.copyOf(keep);
    }

    /** Whether it is shown, be it usable or not. */
    @Override
    public boolean shows(String id) {
        return matches(keep, id) || !matches(hide, id);
    }

    /** Whether it is shown and can be used. */
    public boolean allows(String id) {
        return matches(keep, id) || (!matches(hide, id) && !matches(lock, id));
    }

    /** Why something that is shown cannot be used; empty where it can. */
    @Override
    public Optional<String> whyLocked(String id) {
        return allows(id) ? Optional.empty() : Optional.of("the profile " + name + " does not have it");
    }

    /** Whether nothing is hidden or locked. */
    public boolean isWhole() {
        return hide.isEmpty() && lock.isEmpty();
    }

    private static boolean matches(List<String> patterns, String id) {
        return patterns.stream().anyMatch(pattern -> fits(pattern, id));
    }

    static boolean fits(String pattern, String id) {
        return pattern.endsWith("*") ? id.startsWith(pattern.substring(0, pattern.length() - 1)) : id.equals(pattern);
    }
}
