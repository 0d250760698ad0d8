package org.sami.crw.service;

/** How the first of two quantities compares with the second (appendix .2.2, Quantity Greater, Less, Equal). */
public enum QuantityComparison {
    GREATER,
    LESS,
    EQUAL;

    /** Compares two quantities of one unit; those that differ by at most the tolerance are equal. */
    public static QuantityComparison of(double first, double second, double tolerance) {
        if (Double.isNaN(first) || Double.isNaN(second) || !(tolerance >= 0)) {
            throw new IllegalArgumentException(
                    "Cannot compare " + first + " with " + second + " to a tolerance of " + tolerance);
        }
        if (Math.abs(first - second) <= tolerance) {
            return EQUAL;
        }
        return first > second ? GREATER : LESS;
    }
}
