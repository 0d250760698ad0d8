package org.sami.crw.cli.option;

import org.sami.spn.value.TextNumbers;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads whole numbers, and says in words what is none. */
final class WholeNumberConverter {
    private WholeNumberConverter() {}

    static final ITypeConverter<Integer> INT = text -> (int) read(text, Integer.MIN_VALUE, Integer.MAX_VALUE);

    static final ITypeConverter<Long> LONG = text -> read(text, Long.MIN_VALUE, Long.MAX_VALUE);

    private static long read(String text, long least, long most) {
        return TextNumbers.whole(text, least, most)
                .orElseThrow(() -> new TypeConversionException("expected is a whole number, not '" + text + "'"));
    }
}
