package org.sami.crw.decision;

import java.util.List;

/**
 * What the simulated operator answers: rules in order, the first that fits counts (docs/answers-file.md). Read by
 * {@link AnswersFileReader}.
 */
public final class AnswersFile {
    /** Tells nothing: every answer is the operator's own. */
    public static final AnswersFile EMPTY = new AnswersFile(List.of());

    private final List<AnswerRule> rules;

    AnswersFile(List<AnswerRule> rules) {
        this.rules = List.copyOf(rules);
    }

    List<AnswerRule> rules() {
        return rules;
    }
}
