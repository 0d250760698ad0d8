package org.sami.spn.value;

import java.util.OptionalDouble;
import java.util.OptionalLong;

/** Numbers as people type them and files hold them; a text that is none gives an empty result, so that the caller says what was expected. */
public final class TextNumbers {
    private TextNumbers() {}

    /** A finite decimal number; blanks around it do not count. */
    public static OptionalDouble real(String text) {
        try {
            double number = Double.parseDouble(text.strip());
            return Double.isFinite(number) ? OptionalDouble.of(number) : OptionalDouble.empty();
        } catch (NumberFormatException notANumber) {
            return OptionalDouble.empty();
        }
    }

    /** A decimal number from one to another, both allowed. */
    public static OptionalDouble real(String text, double least, double most) {
        OptionalDouble number = real(text);
        return number.isPresent() && number.getAsDouble() >= least && number.getAsDouble() <= most
                ? number
                : OptionalDouble.empty();
    }

    /** A whole number from one to another, both allowed. */
    public static OptionalLong whole(String text, long least, long most) {
        try {
            long number = Long.parseLong(text.strip());
            return number >= least && number <= most ? OptionalLong.of(number) : OptionalLong.empty();
        } catch (NumberFormatException notANumber) {
            return OptionalLong.empty();
        }
    }
}
