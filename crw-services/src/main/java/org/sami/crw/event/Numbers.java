package org.sami.crw.event;

import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/** Numbers in values: a field of type real takes whole numbers as well. */
public final class Numbers {
    private Numbers() {}

    /**
     * A real or whole number.
     *
     * @throws IllegalArgumentException for a value that is no number
     */
    public static double real(Value value) {
        if (value instanceof RealValue real) {
            return real.value();
        }
        if (value instanceof IntegerValue integer) {
            return integer.value();
        }
        throw new IllegalArgumentException("Not a number: " + value);
    }
}
