package org.sami.spn.value;

/** A span of time in whole milliseconds, never negative. */
public record DurationValue(long millis) implements Value {
    public DurationValue {
        if (millis < 0) {
            throw new IllegalArgumentException("A duration is not negative: " + millis + " ms");
        }
    }
}
