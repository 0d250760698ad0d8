package org.sami.spn.engine.net;

import java.util.Locale;
import java.util.stream.Stream;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** One markup Filter: keeps the options that contain a text, or all but those, without regard to case (thesis 6.3.2). */
public final class OptionFilter {
    private final String text;
    private final boolean exclude;

    OptionFilter(String text, boolean exclude) {
        this.text = fold(text);
        this.exclude = exclude;
    }

    /** Whether a robot is offered. */
    public boolean keeps(String robot, String description) {
        return exclude != (contains(robot) || contains(description));
    }

    /** Whether an option is offered: some text in it, or a name, contains what is looked for. */
    public boolean keeps(Value option) {
        return exclude != texts(option).anyMatch(this::contains);
    }

    private boolean contains(String where) {
        return fold(where).contains(text);
    }

    private static Stream<String> texts(Value value) {
        if (value instanceof TextValue t) {
            return Stream.of(t.value());
        }
        if (value instanceof EnumValue e) {
            return Stream.of(e.constant());
        }
        if (value instanceof ProxyValue p) {
            return Stream.of(p.proxy());
        }
        if (value instanceof TaskId t) {
            return Stream.of(t.name());
        }
        if (value instanceof VariableReference v) {
            return Stream.of(v.variable());
        }
        if (value instanceof ListValue list) {
            return list.items().stream().flatMap(OptionFilter::texts);
        }
        if (value instanceof RecordValue record) {
            return record.fields().values().stream().flatMap(OptionFilter::texts);
        }
        return value instanceof MapValue map
                ? map.entries().entrySet().stream()
                        .flatMap(e -> Stream.of(e.getKey(), e.getValue()).flatMap(OptionFilter::texts))
                : Stream.empty();
    }

    private static String fold(String given) {
        return given.toLowerCase(Locale.ROOT);
    }
}
