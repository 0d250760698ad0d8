package org.sami.session.api;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.Value;

/**
 * What is filled in of an answer so far. Immutable.
 *
 * @param values by the keys of the question's items; what is not filled in yet is missing
 * @param boats that are chosen
 * @param option that is chosen
 */
public record DraftAnswer(Map<String, Value> values, List<String> boats, Optional<Value> option) {
    /** Nothing is filled in. */
    public static final DraftAnswer EMPTY = new DraftAnswer(Map.of(), List.of(), Optional.empty());

    public DraftAnswer {
        values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
        boats = List.copyOf(boats);
        Objects.requireNonNull(option, "option");
    }

    /** Values that are filled in. */
    public static DraftAnswer of(Map<String, Value> values) {
        return new DraftAnswer(values, List.of(), Optional.empty());
    }

    /** What a whole answer says to a question. */
    public static DraftAnswer of(Answer answer, Question question) {
        if (answer instanceof Answer.Fields fields) {
            return of(fields.values());
        } else if (answer instanceof Answer.Proxies chosen) {
            return new DraftAnswer(Map.of(), chosen.proxies(), Optional.empty());
        } else if (answer instanceof Answer.Option option
                && question instanceof Question.ChooseOption asked
                && option.index() >= 0
                && option.index() < asked.options().size()) {
            return new DraftAnswer(
                    Map.of(), List.of(), Optional.of(asked.options().get(option.index())));
        }
        return EMPTY;
    }
}
