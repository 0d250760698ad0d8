package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * Driving by hand: the efforts asked for at this moment.
 *
 * <p>A state and no command: it has no id and no answer, the newest counts, and the boat drops older ones by their sequence number. The boat stops its
 * motors when it has received none for two seconds.
 */
public final class Teleoperate extends LinkMessage {
    static final String TYPE = "teleop";

    private final double thrust;
    private final double rudder;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public Teleoperate(double thrust, double rudder) {
        this.thrust = Checks.range("thrust", thrust, -1, 1);
        this.rudder = Checks.range("rudder", rudder, -1, 1);
    }

    static Teleoperate read(Fields in) throws LinkException {
        return new Teleoperate(in.number("thrust"), in.number("rudder"));
    }

    /** Part of full thrust ahead, -1 to 1. */
    public double thrust() {
        return thrust;
    }

    /** Part of full steering effort, -1 (to port) to 1 (to starboard). */
    public double rudder() {
        return rudder;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeNumberField("thrust", thrust);
        out.writeNumberField("rudder", rudder);
    }
}
