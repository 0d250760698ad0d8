package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Objects;

/** The battery's class of charge; sent at subscription and at each change of class. */
public final class BatteryReport extends LinkMessage {
    static final String TYPE = "battery";

    private final double percent;
    private final BatteryLevel level;

    /** Makes a message of checked values; a value out of its range is an {@link IllegalArgumentException}. */
    public BatteryReport(double percent, BatteryLevel level) {
        this.percent = Checks.range("percent", percent, 0, 100);
        this.level = Objects.requireNonNull(level, "level");
    }

    static BatteryReport read(Fields in) throws LinkException {
        return new BatteryReport(in.number("percent"), in.word("level", BatteryLevel.class));
    }

    /** Charge in percent of full. */
    public double percent() {
        return percent;
    }

    /** The class, by the thresholds of the boat. */
    public BatteryLevel level() {
        return level;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void write(JsonGenerator out) throws IOException {
        out.writeNumberField("percent", percent);
        out.writeStringField("level", level.name());
    }
}
