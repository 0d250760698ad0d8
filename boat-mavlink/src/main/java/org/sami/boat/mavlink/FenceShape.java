package org.sami.boat.mavlink;

import java.util.function.DoubleConsumer;

/** The outline of a zone of a fence. Straight lines are those of a map in degrees; over the 20 km that a boat may be sent, a boat's own path differs from them by a few metres. */
interface FenceShape {
    /** Whether a place is inside. */
    boolean contains(Position at);

    /** Hands over where a straight way crosses the outline, each as a fraction of the way, in no order. */
    void crossings(Position from, Position to, DoubleConsumer fractions);
}
