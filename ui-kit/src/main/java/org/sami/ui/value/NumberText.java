package org.sami.ui.value;

import java.math.BigDecimal;
import java.math.RoundingMode;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;

/**
 * A number; its unit may be typed after it. A comma divides the fraction as a point does, and nothing divides thousands.
 *
 * @param whole whether only whole numbers are
 * @param unit the unit in words, empty text where there is none
 */
record NumberText(boolean whole, String unit) implements TypedText {
    @Override
    public Entry read(String text) {
        String typed = text.strip();
        if (!unit.isEmpty() && typed.endsWith(unit)) {
            typed = typed.substring(0, typed.length() - unit.length()).strip();
        }
        if (typed.isEmpty()) {
            return Entry.nothing("Enter " + kind() + ", such as " + example());
        }
        BigDecimal number;
        try {
            number = new BigDecimal(typed.replace(',', '.'));
        } catch (NumberFormatException notANumber) {
            return Entry.wrong("\"" + Excerpt.of(typed) + "\" is not " + kind() + "; one is " + example());
        }
        return whole ? wholeNumber(number) : realNumber(number);
    }

    private Entry wholeNumber(BigDecimal number) {
        try {
            return Entry.of(new IntegerValue(
                    number.setScale(0, RoundingMode.UNNECESSARY).longValueExact()));
        } catch (ArithmeticException notWhole) {
            return Entry.wrong(
                    number.abs().compareTo(BigDecimal.valueOf(Long.MAX_VALUE)) > 0
                            ? "The number is too large"
                            : "Enter a whole number, such as "
                                    + number.setScale(0, RoundingMode.HALF_UP).toPlainString());
        }
    }

    private static Entry realNumber(BigDecimal number) {
        double value = number.doubleValue();
        return Double.isFinite(value) ? Entry.of(new RealValue(value)) : Entry.wrong("The number is too large");
    }

    private String kind() {
        return (whole ? "a whole number" : "a number") + (unit.isEmpty() ? "" : " in " + unit);
    }

    @Override
    public String write(Value value) {
        if (value instanceof IntegerValue integer) {
            return Long.toString(integer.value());
        }
        BigDecimal number = BigDecimal.valueOf(((RealValue) value).value());
        return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
    }

    @Override
    public String example() {
        return whole ? "10" : "2.5";
    }

    @Override
    public int columns() {
        return 10;
    }
}
