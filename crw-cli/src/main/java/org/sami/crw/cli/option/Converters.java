package org.sami.crw.cli.option;

import picocli.CommandLine;

/** How all command lines of this program read numbers and names of constants. */
public final class Converters {
    private Converters() {}

    /** Has a command line read them so. Gives the command line. */
    public static CommandLine addTo(CommandLine line) {
        line.setCaseInsensitiveEnumValuesAllowed(true);
        line.registerConverter(int.class, WholeNumberConverter.INT);
        line.registerConverter(Integer.class, WholeNumberConverter.INT);
        line.registerConverter(double.class, NumberConverter.DOUBLE);
        line.registerConverter(long.class, WholeNumberConverter.LONG);
        return line;
    }
}
