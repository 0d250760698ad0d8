package org.sami.crw.sim.cli.option;

import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads numbers, and says in words what is none. */
final class NumberConverter {
    private NumberConverter() {}

    static final ITypeConverter<Double> DOUBLE = text -> {
        try {
            double number = Double.parseDouble(text);
            if (Double.isFinite(number)) {
                return number;
            }
        } catch (NumberFormatException e) {
            // said below
        }
        throw new TypeConversionException("expected is a number, not '" + text + "'");
    };
}
