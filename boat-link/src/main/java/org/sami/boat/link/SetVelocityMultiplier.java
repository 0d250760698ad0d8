package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Scales the speed of every leg, of this list and those to come. */
public final class SetVelocityMultiplier extends CommandMessage {
    /** The largest factor. */
    public static final double MAX_MULTIPLIER = 10;

    static final String TYPE = "velocity";

    private final double multiplier;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public SetVelocityMultiplier(String commandId, double multiplier) {
        super(commandId);
        this.multiplier = Checks.range("multiplier", multiplier, 0, MAX_MULTIPLIER);
    }

    static SetVelocityMultiplier read(Fields in) throws LinkException {
        return new SetVelocityMultiplier(in.text("command"), in.number("multiplier"));
    }

    /** Factor on the speed of a leg; the boat's own limit still holds. */
    public double multiplier() {
        return multiplier;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeNumberField("multiplier", multiplier);
    }
}
