package org.sami.crw.cli.option;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads seeds: single ones and ranges with commas between them, such as {@code 1..20} or {@code 3,7,11..13}. */
public final class SeedsConverter implements ITypeConverter<SeedsConverter.Seeds> {
    /** More would take days. */
    private static final int MOST = 10_000;

    private static final Pattern PART = Pattern.compile("(-?\\d{1,18})(?:\\.\\.(-?\\d{1,18}))?");

    /** Each once, in the order in which they were given. */
    public record Seeds(List<Long> all) {
        public Seeds {
            all = List.copyOf(all);
        }
    }

    @Override
    public Seeds convert(String text) {
        Set<Long> seeds = new LinkedHashSet<>();
        for (String part : text.split(",", -1)) {
            Matcher range = PART.matcher(part.strip());
            if (!range.matches()) {
                throw new TypeConversionException("expected are seeds such as 1..20 or 3,7,11, not '" + text + "'");
            }
            long first = Long.parseLong(range.group(1));
            long last = range.group(2) == null ? first : Long.parseLong(range.group(2));
            if (last < first || last - first >= MOST || seeds.size() + last - first >= MOST) {
                throw new TypeConversionException(
                        "seeds go from the smaller to the larger and are at most " + MOST + ", not '" + text + "'");
            }
            for (long seed = first; seed <= last; seed++) {
                seeds.add(seed);
            }
        }
        return new Seeds(new ArrayList<>(seeds));
    }
}
