package org.sami.crw.markup;

import java.util.List;
import java.util.Optional;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Reads the options of the markups on one event. Of several markups of a kind the last one counts, as for services. */
public final class MarkupReader {
    private final List<MarkupSpec> markups;

    /** A reader of the markups on an event. */
    public MarkupReader(List<MarkupSpec> markups) {
        this.markups = List.copyOf(markups);
    }

    /** The markup of a kind, if the event has it. */
    public Optional<MarkupSpec> markup(String kind) {
        return markups.stream().filter(spec -> spec.type().equals(kind)).reduce((first, second) -> second);
    }

    /** What a markup's option says; empty where it is not written. */
    public Optional<Value> option(String kind, String option) {
        return markup(kind).flatMap(spec -> spec.option(option));
    }

    /** As {@link #option}, for a text; empty text where it is not written. */
    public String text(String kind, String option) {
        return option(kind, option)
                .map(value -> value instanceof TextValue text ? text.value() : "")
                .orElse("");
    }

    /** As {@link #option}, for yes or no; no where it is not written. */
    public boolean flag(String kind, String option) {
        return option(kind, option)
                .filter(value -> value instanceof BooleanValue flag && flag.value())
                .isPresent();
    }

    /** As {@link #option}, for an enumeration whose constants have these names. */
    public <E extends Enum<E>> Optional<E> constant(String kind, String option, Class<E> of) {
        return option(kind, option)
                .filter(EnumValue.class::isInstance)
                .map(value -> Enum.valueOf(of, ((EnumValue) value).constant()));
    }
}
