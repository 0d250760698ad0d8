package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.sami.boat.link.Checks.BadValueException;

/** Gains of one control loop, each 0 to 1000; immutable. */
public final class Gains {
    /** The largest gain; what is larger is a mistake. */
    public static final double MAX = 1000;

    private final double proportional;
    private final double integral;
    private final double derivative;

    /** Gains per unit of error, of error and second, and of error change a second. */
    public Gains(double proportional, double integral, double derivative) {
        this.proportional = Checks.range("p", proportional, 0, MAX);
        this.integral = Checks.range("i", integral, 0, MAX);
        this.derivative = Checks.range("d", derivative, 0, MAX);
    }

    static Gains read(Fields in) throws LinkException {
        try {
            return new Gains(in.number("p"), in.number("i"), in.number("d"));
        } catch (BadValueException e) {
            throw in.refused(e);
        }
    }

    void write(JsonGenerator out) throws IOException {
        out.writeNumberField("p", proportional);
        out.writeNumberField("i", integral);
        out.writeNumberField("d", derivative);
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
    public boolean equals(Object other) {
        if (!(other instanceof Gains)) {
            return false;
        }
        Gains that = (Gains) other;
        return Double.compare(proportional, that.proportional) == 0
                && Double.compare(integral, that.integral) == 0
                && Double.compare(derivative, that.derivative) == 0;
    }

    @Override
    public int hashCode() {
        return (Double.hashCode(proportional) * 31 + Double.hashCode(integral)) * 31 + Double.hashCode(derivative);
    }

    @Override
    public String toString() {
        return proportional + ", " + integral + ", " + derivative;
    }
}
