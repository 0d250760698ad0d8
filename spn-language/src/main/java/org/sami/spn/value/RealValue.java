package org.sami.spn.value;

/** A real number; its unit stands in the field that holds it. Never NaN or infinite. */
public record RealValue(double value) implements Value {
    public RealValue {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("A real value is finite, not " + value);
        }
    }
}
