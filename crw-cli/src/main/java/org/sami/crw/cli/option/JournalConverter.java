package org.sami.crw.cli.option;

import org.sami.spn.journal.JournalAddress;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads where a journal is: a file, or {@code postgresql://HOST:PORT/DATABASE}. */
public final class JournalConverter implements ITypeConverter<JournalAddress> {
    @Override
    public JournalAddress convert(String text) {
        try {
            return JournalAddress.parse(text);
        } catch (IllegalArgumentException unfit) {
            throw new TypeConversionException(unfit.getMessage());
        }
    }
}
