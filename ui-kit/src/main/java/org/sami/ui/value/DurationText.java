package org.sami.ui.value;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;

/** A span of time, such as {@code 90 s}, {@code 1 h 30 min} or {@code 1:30:00}; a mere number is seconds. */
record DurationText() implements TypedText {
    private static final String EXAMPLE = "1 min 30 s";
    private static final BigDecimal LONGEST = BigDecimal.valueOf(365L * 24 * 3_600_000);
    private static final Pattern PART = Pattern.compile("(\\d+(?:[.,]\\d+)?)\\s*([a-z]*)\\s*");
    private static final Pattern CLOCK = Pattern.compile("(?:(\\d+):)?(\\d{1,2}):(\\d{1,2}(?:[.,]\\d+)?)");
    private static final Map<String, Long> MILLIS = Map.ofEntries(
            Map.entry("ms", 1L),
            Map.entry("", 1_000L),
            Map.entry("s", 1_000L),
            Map.entry("sec", 1_000L),
            Map.entry("m", 60_000L),
            Map.entry("min", 60_000L),
            Map.entry("h", 3_600_000L),
            Map.entry("d", 86_400_000L));

    @Override
    public Entry read(String text) {
        String typed = text.strip().toLowerCase(Locale.ROOT);
        if (typed.isEmpty()) {
            return Entry.nothing("Enter a duration, such as " + EXAMPLE);
        }
        Matcher clock = CLOCK.matcher(typed);
        if (clock.matches()) {
            BigDecimal hours = clock.group(1) == null ? BigDecimal.ZERO : parse(clock.group(1));
            BigDecimal minutes = hours.multiply(BigDecimal.valueOf(60)).add(parse(clock.group(2)));
            BigDecimal seconds = minutes.multiply(BigDecimal.valueOf(60)).add(parse(clock.group(3)));
            return millis(seconds.multiply(BigDecimal.valueOf(1000)));
        }
        return parts(typed);
    }

    private static Entry parts(String typed) {
        BigDecimal sum = BigDecimal.ZERO;
        Matcher part = PART.matcher(typed);
        int end = 0;
        while (part.lookingAt()) {
            Long unit = MILLIS.get(part.group(2));
            if (unit == null) {
                return Entry.wrong(
                        "\"" + Excerpt.of(part.group(2)) + "\" is no unit of time; units are ms, s, min, h and d");
            }
            sum = sum.add(parse(part.group(1)).multiply(BigDecimal.valueOf(unit)));
            end = part.end();
            part.region(end, typed.length());
        }
        return end < typed.length()
                ? Entry.wrong("\"" + Excerpt.of(typed) + "\" is not a duration; one is " + EXAMPLE)
                : millis(sum);
    }

    private static BigDecimal parse(String digits) {
        return new BigDecimal(digits.replace(',', '.'));
    }

    private static Entry millis(BigDecimal millis) {
        return millis.compareTo(LONGEST) > 0
                ? Entry.wrong("A duration of more than a year is too long")
                : Entry.of(new DurationValue(
                        millis.setScale(0, RoundingMode.HALF_UP).longValueExact()));
    }

    @Override
    public String write(Value value) {
        return write(((DurationValue) value).millis());
    }

    /** Milliseconds in the largest units that fit: {@code 1 h 5 s}. */
    static String write(long millis) {
        StringBuilder text = new StringBuilder();
        append(text, millis / 3_600_000, "h");
        append(text, millis / 60_000 % 60, "min");
        append(text, millis / 1000 % 60, "s");
        append(text, millis % 1000, "ms");
        return text.isEmpty() ? "0 s" : text.toString();
    }

    private static void append(StringBuilder text, long amount, String unit) {
        if (amount > 0) {
            text.append(text.isEmpty() ? "" : " ").append(amount).append(' ').append(unit);
        }
    }

    @Override
    public String example() {
        return EXAMPLE;
    }

    @Override
    public int columns() {
        return 14;
    }
}
