package org.sami.crw.cli.option;

import org.sami.spn.value.TextNumbers;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads numbers, and says in words what is none. */
final class NumberConverter {
    private NumberConverter() {}

    static final ITypeConverter<Double> DOUBLE = text -> TextNumbers.real(text)
            .orElseThrow(() -> new TypeConversionException("expected is a number, not '" + text + "'"));
}
