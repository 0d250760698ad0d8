package org.sami.spn.json;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldLimits;
import org.sami.spn.vocabulary.FieldLimits.Range;
import org.sami.spn.vocabulary.FieldType;

/** Reads which values of its type a field can have. */
final class FieldLimitsReader {
    private static final String MEMBER = "limits";
    private static final String ABOVE = "above";
    private static final String WORDS = "words";
    private static final Set<ValueType> NUMBERS =
            Set.of(ValueType.Simple.INTEGER, ValueType.Simple.REAL, ValueType.Simple.DURATION);

    private FieldLimitsReader() {}

    /** The limits of a field's declaration; its type where that is known. */
    static FieldLimits read(JsonObjectReader field, Optional<ValueType> type, Problems problems) {
        return field.object(MEMBER)
                .map(m -> {
                    Range range = range(m, "range", problems);
                    Range usual = range(m, "usual", problems);
                    Optional<String> above = m.has(ABOVE) ? Optional.of(m.text(ABOVE)) : Optional.empty();
                    List<String> words = m.texts(WORDS);
                    m.done();
                    FieldLimits limits = new FieldLimits(range, usual, above, words);
                    type.ifPresent(t -> check(field, limits, t));
                    return limits;
                })
                .orElse(FieldLimits.NONE);
    }

    private static Range range(JsonObjectReader m, String member, Problems problems) {
        if (!m.has(member)) {
            return Range.ALL;
        }
        List<JsonObjectReader.Element> ends = m.array(member);
        boolean numbers =
                ends.size() == 2 && ends.stream().allMatch(e -> e.node().isNumber());
        if (!numbers || ends.get(0).node().doubleValue() > ends.get(1).node().doubleValue()) {
            problems.add(
                    Codes.BAD_VALUE, m.at(member), "A range is the least and the greatest number, such as [0, 100]");
            return Range.ALL;
        }
        return new Range(ends.get(0).node().doubleValue(), ends.get(1).node().doubleValue());
    }

    private static void check(JsonObjectReader field, FieldLimits limits, ValueType type) {
        boolean ofNumbers = !limits.range().equals(Range.ALL)
                || !limits.usual().equals(Range.ALL)
                || limits.above().isPresent();
        if (ofNumbers && !NUMBERS.contains(type)) {
            field.problem(
                    Codes.BAD_VALUE,
                    MEMBER,
                    "\"range\", \"usual\" and \"above\" are for fields of type integer, real or duration");
        }
        if (!limits.words().isEmpty() && type != ValueType.Simple.TEXT) {
            field.problem(Codes.BAD_VALUE, MEMBER, "\"words\" are for fields of type text");
        }
    }

    /** Reports a limit by a field that the event does not have, or that has another type. */
    static void checkOrder(List<FieldType> fields, String pointer, Problems problems) {
        for (FieldType field : fields) {
            field.limits()
                    .above()
                    .filter(above -> fields.stream()
                            .noneMatch(other -> !other.name().equals(field.name())
                                    && other.name().equals(above)
                                    && other.type().equals(field.type())))
                    .ifPresent(above -> problems.add(
                            Codes.BAD_VALUE,
                            pointer,
                            "The field " + field.name() + " is to be above \"" + above
                                    + "\", which is no other field of the event with its type"));
        }
    }
}
