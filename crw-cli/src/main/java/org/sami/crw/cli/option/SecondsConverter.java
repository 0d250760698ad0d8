package org.sami.crw.cli.option;

import org.sami.spn.value.TextNumbers;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads seconds of simulated time, with parts, as milliseconds. */
public final class SecondsConverter implements ITypeConverter<Long> {
    private static final double MOST_SECONDS = 366 * 86_400.0;

    @Override
    public Long convert(String text) {
        double seconds = TextNumbers.real(text, 0, MOST_SECONDS)
                .orElseThrow(() ->
                        new TypeConversionException("expected is a number of seconds, 0 or more, not '" + text + "'"));
        return Math.round(seconds * 1000);
    }
}
