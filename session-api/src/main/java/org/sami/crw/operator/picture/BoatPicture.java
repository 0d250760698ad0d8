package org.sami.crw.operator.picture;

import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * One picture that a boat took. Immutable.
 *
 * @param name of its file on board
 * @param file where it is on this machine; empty while it is not here
 * @param missed why it will not come, in words; empty while it may
 */
public record BoatPicture(String name, Optional<Path> file, String missed) {
    public BoatPicture {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(missed, "missed");
    }

    /** A picture that has not come yet. */
    public static BoatPicture coming(String name) {
        return new BoatPicture(name, Optional.empty(), "");
    }

    /** Whether it may still come. */
    public boolean isComing() {
        return file.isEmpty() && missed.isEmpty();
    }

    /** Why it cannot be seen, in words; empty where it is here. */
    public String words() {
        return file.isPresent() ? "" : missed.isEmpty() ? "this picture is not here yet" : missed;
    }
}
