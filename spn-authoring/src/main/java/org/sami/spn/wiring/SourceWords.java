package org.sami.spn.wiring;

import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** Sources in words, as authors choose them. */
public final class SourceWords {
    private SourceWords() {}

    /** What a source is, and how far away: {@code Operator Creates Locations: locations, 1 step before}. */
    public static String of(DataSource source, Vocabulary vocabulary) {
        if (source instanceof DataSource.AnswerField answer) {
            return vocabulary.title(answer.type()) + ": "
                    + answer.field()
                    + answer.variable().map(v -> " (" + v + ")").orElse("") + ", " + steps(answer.steps());
        }
        if (source instanceof DataSource.Variable variable) {
            return variable.name()
                    + switch (variable.origin()) {
                        case WRITTEN_BEFORE -> ", written " + steps(variable.steps());
                        case FIRST_VALUE -> ", its first value";
                        case PARENT -> ", of a parent or the project";
                        case NOTHING_BEFORE -> ", written by nothing before";
                    };
        }
        return "the entering task (@task)";
    }

    /** What a source is, where there is room for a name alone: the answer's, or the variable's. */
    public static String brief(DataSource source, Vocabulary vocabulary) {
        if (source instanceof DataSource.AnswerField answer) {
            return vocabulary.title(answer.type());
        }
        return source instanceof DataSource.Variable variable ? variable.name() : Reserved.TASK_VARIABLE;
    }

    private static String steps(int steps) {
        return steps + (steps == 1 ? " step before" : " steps before");
    }
}
