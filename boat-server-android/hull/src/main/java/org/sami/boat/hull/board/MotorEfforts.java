package org.sami.boat.hull.board;

/** What the board is commanded: for a differential hull both motors, for a rudder hull the motor and the rudder; -1 to 1 each. Immutable. */
public final class MotorEfforts {
    /** Everything off, rudder amidships. */
    public static final MotorEfforts NONE = new MotorEfforts(0, 0);

    private final double first;
    private final double second;

    MotorEfforts(double first, double second) {
        this.first = first;
        this.second = second;
    }

    /** The board's first motor, {@code m0}. */
    public double first() {
        return first;
    }

    /** The board's second motor, {@code m1}, or the rudder, {@code s0}. */
    public double second() {
        return second;
    }

    /** Whether nothing is driven. */
    public boolean areNone() {
        return first == 0 && second == 0;
    }
}
