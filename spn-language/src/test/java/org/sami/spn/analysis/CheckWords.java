package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.AnswerNames;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldLimits;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The test vocabulary and, next to it, {@code Drive(speed)}, a command to proxies that {@code Driven} answers, naming them,
 * {@code Fetch}, which can fail
 * ({@code NotFetched}, and {@code BatteryOut}, which is news too), and {@code Work}, a request about tasks; {@code Sail}, a second
 * command, {@code Watch(every, low, critical, sensor)}, whose fields have limits and which {@code Well} answers when all is well, and
 * {@code Gather(at)} of robots that {@code Greet(name)} lists.
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
        events.add(event("Sail", Direction.OUTPUT, List.of(), TokenNeed.PROXY, List.of("Sailed"), EventFlag.COMMAND));
        events.add(event("Sailed", Direction.INPUT, List.of(), TokenNeed.PROXY, List.of()));
        FieldLimits.Range percent = new FieldLimits.Range(0, 100);
        events.add(event(
                "Watch",
                Direction.OUTPUT,
                List.of(
                        limited(
                                "every",
                                ValueType.Simple.DURATION,
                                "",
                                new FieldLimits(
                                        FieldLimits.Range.ALL,
                                        new FieldLimits.Range(0.1, 3600),
                                        Optional.empty(),
                                        List.of())),
                        limited(
                                "low",
                                ValueType.Simple.REAL,
                                "%",
                                new FieldLimits(percent, percent, Optional.of("critical"), List.of())),
                        limited(
                                "critical",
                                ValueType.Simple.REAL,
                                "%",
                                new FieldLimits(percent, percent, Optional.empty(), List.of())),
                        limited(
                                "sensor",
                                ValueType.Simple.TEXT,
                                "",
                                new FieldLimits(
                                        FieldLimits.Range.ALL,
                                        FieldLimits.Range.ALL,
                                        Optional.empty(),
                                        List.of("temperature", "oxygen")))),
                TokenNeed.PROXY,
                List.of("Well")));
        events.add(event(
                "Well", Direction.INPUT, List.of(), TokenNeed.PROXY, List.of(), EventFlag.NEWS, EventFlag.NOMINAL));
        events.add(event(
                "Gather",
                Direction.OUTPUT,
                List.of(limited(
                        "at",
                        new ValueType.MapOf(ValueType.Simple.PROXY, ValueType.Simple.POINT),
                        "",
                        FieldLimits.NONE)),
                TokenNeed.NONE,
                List.of()));
        events.add(event(
                "Greet",
                Direction.OUTPUT,
                List.of(limited("name", ValueType.Simple.TEXT, "", FieldLimits.NONE)),
                TokenNeed.NONE,
                List.of()));
        events.add(new EventType(
                "Define",
                List.of(),
                Direction.OUTPUT,
                List.of(limited("variables", new ValueType.ListOf(ValueType.Simple.VARIABLE), "", FieldLimits.NONE)),
                TokenNeed.NONE,
                List.of("Yes"),
                EventRole.NONE,
                Set.of(),
                Optional.of(new DecisionType(
                        DecisionForm.DEFINE_VARIABLES,
                        "Yes",
                        "",
                        0,
                        1,
                        "",
                        Map.of(),
                        AnswerNames.NOBODY,
                        AutonomyAnswer.DEFAULTS)),
                "Define",
                ""));
        return new Vocabulary(
                base.domain(),
                List.copyOf(base.types().values()),
                events,
                List.copyOf(base.markups().values()),
                List.copyOf(base.taskClasses().values()),
                Optional.empty(),
                Map.of("Greet", "name"));
    }

    private static FieldType limited(String name, ValueType type, String unit, FieldLimits limits) {
        return new FieldType(name, type, unit, false, Optional.empty(), "", Optional.empty(), limits);
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
