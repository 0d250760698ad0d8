package org.sami.boat.server;

/** Gains of one control loop; immutable. */
public final class Gains {
    private final double proportional;
    private final double integral;
    private final double derivative;

    /** Gains per unit of error, of error and second, and of error change a second; none negative. */
    public Gains(double proportional, double integral, double derivative) {
        if (!(proportional >= 0 && integral >= 0 && derivative >= 0)) {
            throw new IllegalArgumentException("gains " + proportional + ", " + integral + ", " + derivative);
        }
        this.proportional = proportional;
        this.integral = integral;
        this.derivative = derivative;
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
}
