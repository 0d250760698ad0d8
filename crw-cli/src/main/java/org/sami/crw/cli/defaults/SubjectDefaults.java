package org.sami.crw.cli.defaults;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;

/** Collects the defaults of one subject. */
final class SubjectDefaults {
    private final String name;
    private final List<DefaultValue> values = new ArrayList<>();

    SubjectDefaults(String name) {
        this.name = name;
    }

    /** A number that no option, file or plan sets. */
    SubjectDefaults number(String what, double number, String unit, String meaning) {
        return number(what, number, unit, meaning, DefaultValue.NOWHERE);
    }

    SubjectDefaults number(String what, double number, String unit, String meaning, String setBy) {
        return text(what, BigDecimal.valueOf(number).stripTrailingZeros().toPlainString(), unit, meaning, setBy);
    }

    /** Milliseconds, which are shown as seconds. */
    SubjectDefaults millis(String what, long millis, String meaning) {
        return number(what, millis / 1000.0, "s", meaning);
    }

    SubjectDefaults text(String what, String value, String unit, String meaning, String setBy) {
        values.add(new DefaultValue(name, what, value, unit, meaning, setBy));
        return this;
    }

    List<DefaultValue> values() {
        return values;
    }
}
