package org.sami.crw.sim.run.settings;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.OptionalDouble;
import org.sami.spn.value.TextNumbers;

/**
 * How many simulated seconds pass in one second of the wall clock.
 *
 * @param factor above zero; infinite for {@link #MAX}
 */
public record Speed(double factor) {
    /** As fast as the machine can. */
    public static final Speed MAX = new Speed(Double.POSITIVE_INFINITY);

    /** As fast as it would really be. */
    public static final Speed REAL = new Speed(1);

    public Speed {
        if (!(factor > 0)) {
            throw new IllegalArgumentException("a speed is above 0, not " + factor);
        }
    }

    /**
     * Reads {@code max} or a number.
     *
     * @throws IllegalArgumentException saying what is allowed
     */
    public static Speed parse(String text) {
        String word = text.strip().toLowerCase(Locale.ROOT);
        if (word.equals("max")) {
            return MAX;
        }
        OptionalDouble factor = TextNumbers.real(
                word.endsWith("x") ? word.substring(0, word.length() - 1) : word, Double.MIN_VALUE, Double.MAX_VALUE);
        if (factor.isPresent()) {
            return new Speed(factor.getAsDouble());
        }
        throw new IllegalArgumentException("a speed is 'max' or a number above 0 (1 = real time), not '" + text + "'");
    }

    /** Whether nobody waits. */
    public boolean isMax() {
        return Double.isInfinite(factor);
    }

    @Override
    public String toString() {
        return isMax() ? "max" : BigDecimal.valueOf(factor).stripTrailingZeros().toPlainString();
    }
}
