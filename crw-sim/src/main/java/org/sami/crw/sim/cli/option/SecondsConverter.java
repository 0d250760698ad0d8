package org.sami.crw.sim.cli.option;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads seconds of simulated time, with parts, as milliseconds. */
public final class SecondsConverter implements ITypeConverter<Long> {
    private static final double MOST_SECONDS = 366 * 86_400.0;

    @Override
    public Long convert(String text) {
        try {
            double seconds = Double.parseDouble(text);
            if (seconds >= 0 && seconds <= MOST_SECONDS) {
                return Math.round(seconds * 1000);
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw new TypeConversionException("expected is a number of seconds, 0 or more, not '" + text + "'");
    }
}
