package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** Sets the gains of one control loop of the boat. */
public final class SetGains extends CommandMessage {
    static final String TYPE = "gains";

    private final GainAxis axis;
    private final Gains gains;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public SetGains(String commandId, GainAxis axis, double proportional, double integral, double derivative) {
        this(commandId, axis, new Gains(proportional, integral, derivative));
    }

    /** Makes a message of checked values. */
    public SetGains(String commandId, GainAxis axis, Gains gains) {
        super(commandId);
        this.axis = Objects.requireNonNull(axis, "axis");
        this.gains = Objects.requireNonNull(gains, "gains");
    }

    static SetGains read(Fields in) throws LinkException {
        return new SetGains(in.text("command"), in.word("axis", GainAxis.class), Gains.read(in));
    }

    /** The control loop. */
    public GainAxis axis() {
        return axis;
    }

    /** Its gains from now on. */
    public Gains gains() {
        return gains;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeCommand(JsonGenerator out) throws IOException {
        out.writeStringField("axis", axis.name());
        gains.write(out);
    }
}
