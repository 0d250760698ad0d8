package org.sami.boat.server.vehicle;

import java.util.Collections;
import java.util.List;

/**
 * One channel of one instrument on the hull. The thread that ticks the server reads it and waits for it: a slow instrument is read on another thread and
 * returns its last measurement here.
 */
public interface Sensor {

    /** Names the instrument on this boat. */
    String name();

    /** What of the instrument this is, as {@code temperature}. */
    String channel();

    /** The unit of its values; empty for none. */
    String unit();

    /** Time in ms between two readings; at least that between two ticks of the server. */
    long periodMs();

    /** What it measures now; empty if it has nothing to say. Values that are no finite numbers are not reported. */
    List<Double> read();

    /** A reading of one value. */
    static List<Double> single(double value) {
        return Collections.singletonList(value);
    }
}
