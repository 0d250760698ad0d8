package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The test vocabulary and, beside it, {@code Drive(speed)}, a command to proxies that {@code Driven} answers, naming them,
 * {@code Fetch}, which can fail
 * ({@code NotFetched}, and {@code BatteryOut}, which is news too), and {@code Work}, a request about tasks.
 */
final class CheckWords {
    static final Vocabulary WORDS = build();

    private CheckWords() {}

    private static Vocabulary build() {
        Vocabulary base = TestVocabulary.TEST;
        List<EventType> events = new ArrayList<>(base.events().values());
        FieldType speed = new FieldType("speed", ValueType.Simple.REAL, "m/s", true, Optional.empty(), "");
        events.add(event(
                "Drive", Direction.OUTPUT, List.of(speed), TokenNeed.PROXY, List.of("Driven"), EventFlag.COMMAND));
        events.add(event("Driven", Direction.INPUT, List.of(), TokenNeed.PROXY, List.of()));
        events.add(event(
                "Fetch", Direction.OUTPUT, List.of(), TokenNeed.PROXY, List.of("Fetched", "NotFetched", "BatteryOut")));
        events.add(event("Fetched", Direction.INPUT, List.of(), TokenNeed.PROXY, List.of()));
        events.add(event("NotFetched", Direction.INPUT, List.of(), TokenNeed.PROXY, List.of(), EventFlag.FAILURE));
        events.add(event(
                "BatteryOut",
                Direction.INPUT,
                List.of(),
                TokenNeed.PROXY,
                List.of(),
                EventFlag.FAILURE,
                EventFlag.NEWS));
        events.add(event("Work", Direction.OUTPUT, List.of(), TokenNeed.TASK, List.of()));
        return new Vocabulary(
                base.domain(),
                List.copyOf(base.types().values()),
                events,
                List.copyOf(base.markups().values()),
                List.copyOf(base.taskClasses().values()));
    }

    private static EventType event(
            String name,
            Direction direction,
            List<FieldType> fields,
            TokenNeed tokens,
            List<String> answers,
            EventFlag... flags) {
        return new EventType(
                name,
                List.of(),
                direction,
                fields,
                tokens,
                answers,
                EventRole.NONE,
                Set.of(flags),
                Optional.empty(),
                name,
                "");
    }
}
