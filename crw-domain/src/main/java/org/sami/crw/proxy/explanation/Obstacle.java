package org.sami.crw.proxy.explanation;

import java.util.Optional;

/**
 * What keeps every command from a boat.
 *
 * @param text in words
 */
public record Obstacle(BoatExplanation.Cause cause, String text) {
    /** An obstacle that is there. */
    public static Optional<Obstacle> because(BoatExplanation.Cause cause, String text) {
        return Optional.of(new Obstacle(cause, text));
    }
}
