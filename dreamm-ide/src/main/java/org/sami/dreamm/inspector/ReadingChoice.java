package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.SourceWords;

/**
 * One thing that a field can be read from, as a list offers it.
 *
 * @param source empty for a new variable, and for one that is read although it is none of the sources
 * @param variable that is read; empty where reading it declares one
 */
record ReadingChoice(Optional<DataSource> source, Optional<String> variable, String words) {
    static final String NEW_VARIABLE = "new variable…";

    /**
     * What is offered, nearest first; a new variable last.
     *
     * @param now the variable that is read now
     */
    static List<ReadingChoice> of(List<DataSource> sources, Optional<String> now, Vocabulary vocabulary) {
        List<ReadingChoice> choices = new ArrayList<>();
        for (DataSource source : sources) {
            if (!(source instanceof DataSource.EnteringTask)) {
                choices.add(
                        new ReadingChoice(Optional.of(source), variable(source), SourceWords.of(source, vocabulary)));
            }
        }
        now.filter(v -> choices.stream().noneMatch(c -> c.variable().equals(now)))
                .ifPresent(v -> choices.add(new ReadingChoice(Optional.empty(), now, v)));
        choices.add(new ReadingChoice(Optional.empty(), Optional.empty(), NEW_VARIABLE));
        return choices;
    }

    /** What it is where the list is closed: the variable. */
    String brief() {
        return variable.orElse(words);
    }

    private static Optional<String> variable(DataSource source) {
        return source instanceof DataSource.AnswerField answer
                ? answer.variable()
                : Optional.of(((DataSource.Variable) source).name());
    }
}
