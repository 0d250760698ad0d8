package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/**
 * Drive by hand: the wished efforts of this moment.
 *
 * <p>It is a state and not a command: it has no id and no answer, the newest counts, and an older one that arrives late is
 * dropped by its sequence number. The boat stops its motors when none has come for two seconds.
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
