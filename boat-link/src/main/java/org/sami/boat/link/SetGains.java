package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** Sets the gains of one control loop of the boat. */
public final class SetGains extends CommandMessage {
    static final String TYPE = "gains";

    private final GainAxis axis;
    private final double proportional;
    private final double integral;
    private final double derivative;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public SetGains(String commandId, GainAxis axis, double proportional, double integral, double derivative) {
        super(commandId);
        this.axis = Objects.requireNonNull(axis, "axis");
        this.proportional = Checks.range("p", proportional, 0, Checks.MAX_GAIN);
        this.integral = Checks.range("i", integral, 0, Checks.MAX_GAIN);
        this.derivative = Checks.range("d", derivative, 0, Checks.MAX_GAIN);
    }

    static SetGains read(Fields in) throws LinkException {
        return new SetGains(
                in.text("command"), in.word("axis", GainAxis.class), in.number("p"), in.number("i"), in.number("d"));
    }

    /** The control loop. */
    public GainAxis axis() {
        return axis;
    }

    /** Effort per unit of error. */
    public double proportional() {
        return proportional;
    }

    /** Effort per unit of error and second. */
    public double integral() {
        return integral;
    }

    /** Effort per unit of error change a second. */
    public double derivative() {
        return derivative;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("axis", axis.name());
        out.writeNumberField("p", proportional);
        out.writeNumberField("i", integral);
        out.writeNumberField("d", derivative);
    }
}
