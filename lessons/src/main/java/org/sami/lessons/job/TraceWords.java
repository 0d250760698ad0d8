package org.sami.lessons.job;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.stream.Collectors;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** Words for what is seen from outside. */
final class TraceWords {
    private final Vocabulary vocabulary;

    TraceWords(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /** "at 4 s", "at 0.5 s". */
    static String at(long millis) {
        return millis == 0
                ? "at the start"
                : millis % 1000 == 0
                        ? "at " + millis / 1000 + " s"
                        : String.format(Locale.ROOT, "at %.1f s", millis / 1000.0);
    }

    /** What a reader sees: "Proxy Goto Point for bert". */
    String what(TraceItem item) {
        if (item.type().equals(WorldTrace.ASKED_AT_START)) {
            return "a question for "
                    + item.values().values().stream().map(this::field).collect(Collectors.joining(", "))
                    + " before the start";
        }
        String whom = whom(item.robots(), item.tasks());
        return vocabulary.title(item.type()) + (whom.isEmpty() ? "" : " for " + whom);
    }

    private String field(String key) {
        int dot = key.indexOf('.');
        return dot < 0 ? key : "the field " + key.substring(dot + 1) + " of " + vocabulary.title(key.substring(0, dot));
    }

    private static String whom(List<String> robots, List<Integer> tasks) {
        String names = String.join(", ", robots);
        String numbers = tasks.isEmpty()
                ? ""
                : (tasks.size() == 1 ? "task " : "tasks ")
                        + tasks.stream().map(String::valueOf).collect(Collectors.joining(", "));
        return numbers.isEmpty() ? names : names.isEmpty() ? numbers : numbers + " (" + names + ")";
    }

    /** The fields in which two items differ. */
    String differing(TraceItem one, TraceItem other) {
        return vocabulary.event(one.type()).map(EventType::fields).orElse(List.of()).stream()
                .map(field -> field.name())
                .filter(field ->
                        !Objects.equals(one.values().get(field), other.values().get(field)))
                .map(field -> "\"" + field + "\"")
                .collect(Collectors.joining(", "));
    }
}
