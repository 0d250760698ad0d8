package org.sami.crw.proxy;

import java.util.Optional;

/**
 * What keeps every command from a boat.
 *
 * @param text in words
 */
record Obstacle(BoatExplanation.Cause cause, String text) {
    static Optional<Obstacle> because(BoatExplanation.Cause cause, String text) {
        return Optional.of(new Obstacle(cause, text));
    }
}
