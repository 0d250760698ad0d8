package org.sami.lessons.job;

import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Who answers an output event in a hidden case. */
enum Answering {
    /** The engine, or nobody. */
    NOBODY,
    OPERATOR,
    /** Each robot by itself, one after another. */
    ROBOTS,
    /** A robot that connects. */
    NEW_ROBOT,
    /** At once, for each task by itself. */
    TASKS,
    /** At once, for all who entered. */
    SERVICE;

    /** An event of such a name asks for news for as long as the visit lasts: nothing happens unless the script says so. */
    private static final String SUBSCRIPTION = "Subscription";

    static Answering of(EventType type) {
        if (type.decision().isPresent()) {
            return OPERATOR;
        } else if (type.role() != EventRole.NONE || type.answers().isEmpty()) {
            return NOBODY;
        } else if (type.name().endsWith(SUBSCRIPTION)) {
            return ROBOTS;
        } else if (type.flags().contains(EventFlag.COMMAND)) {
            return ROBOTS;
        } else if (type.tokens() == TokenNeed.TASK) {
            return TASKS;
        }
        return type.flags().contains(EventFlag.ANSWER_OPTIONAL) ? ROBOTS : SERVICE;
    }

    /** As {@link #of(EventType)}; what is asked of nobody and answered with a robot connects one. */
    static Answering of(EventType type, Vocabulary vocabulary) {
        Answering answering = of(type);
        boolean connects = answering == SERVICE
                && type.tokens() == TokenNeed.NONE
                && type.answers().stream()
                        .flatMap(answer -> vocabulary.event(answer).stream())
                        .anyMatch(answer -> answer.tokens() == TokenNeed.PROXY);
        return connects ? NEW_ROBOT : answering;
    }

    /** Whether it is not answered where the script says nothing. */
    static boolean isSilent(EventType type) {
        return type.name().endsWith(SUBSCRIPTION);
    }
}
