package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/**
 * The settings that are in force on the boat. Sent with every welcome, and to all clients after a command has set one of them,
 * behind its answer: so that whoever set it sees what it has come to, and whoever watches sees that it was set.
 */
public final class SettingsReport extends LinkMessage {
    static final String TYPE = "settings";

    private final Gains heading;
    private final Gains speed;
    private final double velocityMultiplier;
    private final LostLinkAction lostLinkAction;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public SettingsReport(Gains heading, Gains speed, double velocityMultiplier, LostLinkAction lostLinkAction) {
        this.heading = Objects.requireNonNull(heading, "heading");
        this.speed = Objects.requireNonNull(speed, "speed");
        this.velocityMultiplier =
                Checks.range("multiplier", velocityMultiplier, 0, SetVelocityMultiplier.MAX_MULTIPLIER);
        this.lostLinkAction = Objects.requireNonNull(lostLinkAction, "lostLinkAction");
    }

    static SettingsReport read(Fields in) throws LinkException {
        return new SettingsReport(
                Gains.read(in.object("heading")),
                Gains.read(in.object("speed")),
                in.number("multiplier"),
                in.word("action", LostLinkAction.class));
    }

    /** Gains of a control loop. */
    public Gains gains(GainAxis axis) {
        return axis == GainAxis.HEADING ? heading : speed;
    }

    /** Factor on the speed of every leg. */
    public double velocityMultiplier() {
        return velocityMultiplier;
    }

    /** What the boat does when the link to its commander is lost. */
    public LostLinkAction lostLinkAction() {
        return lostLinkAction;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeObjectFieldStart("heading");
        heading.write(out);
        out.writeEndObject();
        out.writeObjectFieldStart("speed");
        speed.write(out);
        out.writeEndObject();
        out.writeNumberField("multiplier", velocityMultiplier);
        out.writeStringField("action", lostLinkAction.name());
    }
}
