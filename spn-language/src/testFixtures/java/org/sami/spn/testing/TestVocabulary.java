package org.sami.spn.testing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.AnswerNames;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Words for tests: a domain that has one event of every role and decision form, and nothing of boats.
 *
 * <ul>
 *   <li>{@code Do(point?, speed?, text?)} is answered by {@code Done}, {@code Failed(reason)} or {@code Done2}; nobody does it.
 *   <li>{@code News}, {@code Other} are news; {@code Pose} is coalesced news.
 *   <li>{@code Approve(question?)}, {@code Choose}, {@code ChooseSome} (may be none), {@code Pick(options)},
 *       {@code Provide}, {@code Redefine(variable)} ask the operator.
 *   <li>the rest are the engine's own, named after their roles.
 * </ul>
 */
public final class TestVocabulary {
    /** The vocabulary. */
    public static final Vocabulary TEST = build();

    private TestVocabulary() {}

    private static Vocabulary build() {
        List<EventType> events = new ArrayList<>();
        events.add(output(
                "Do",
                List.of("Done", "Done2", "Failed"),
                EventRole.NONE,
                field("point", ValueType.Simple.POINT),
                field("speed", ValueType.Simple.REAL),
                field("text", ValueType.Simple.TEXT),
                field("number", ValueType.Simple.INTEGER)));
        events.add(input("Done", EventRole.NONE, field("value", ValueType.Simple.INTEGER)));
        events.add(input("Done2", EventRole.NONE, field("value", ValueType.Simple.INTEGER)));
        events.add(input("Failed", EventRole.NONE, field("reason", ValueType.Simple.TEXT)));
        events.add(input("News", EventRole.NONE, field("value", ValueType.Simple.INTEGER)));
        events.add(input("Other", EventRole.NONE, field("value", ValueType.Simple.INTEGER)));
        events.add(new EventType(
                "Pose",
                List.of(),
                Direction.INPUT,
                List.of(),
                TokenNeed.PROXY,
                List.of(),
                EventRole.NONE,
                Set.of(EventFlag.COALESCE),
                Optional.empty(),
                "Pose",
                ""));
        addDecisions(events);
        addRoles(events);
        List<NamedType> types = List.of(
                new NamedType.Enumeration("Trigger", List.of("NEVER", "IMMEDIATELY", "TIMER")),
                new NamedType.Enumeration("FilterAction", List.of("INCLUDE", "EXCLUDE")),
                new NamedType.Enumeration("SelectionDefault", List.of("ALL", "NONE")),
                new NamedType.Enumeration("Rank", List.of("LOW", "MEDIUM", "HIGH", "CRITICAL")),
                new NamedType.RecordType("Choice", new LinkedHashMap<>(Map.of("text", ValueType.Simple.TEXT))));
        List<MarkupType> markups = List.of(
                new MarkupType(
                        "MixedInitiativeTrigger",
                        List.of(),
                        List.of(
                                field("trigger", new ValueType.Named("Trigger")),
                                field("timeout", ValueType.Simple.DURATION)),
                        "Mixed initiative trigger",
                        ""),
                new MarkupType(
                        "Filter",
                        List.of(),
                        List.of(
                                field("source", ValueType.Simple.TEXT),
                                field("action", new ValueType.Named("FilterAction"))),
                        "Filter",
                        ""),
                new MarkupType(
                        "DefaultSelection",
                        List.of(),
                        List.of(field("selection", new ValueType.Named("SelectionDefault"))),
                        "Default selection",
                        ""),
                new MarkupType(
                        "Priority", List.of(), List.of(field("rank", new ValueType.Named("Rank"))), "Priority", ""));
        return new Vocabulary(
                "test",
                types,
                events,
                markups,
                List.of(
                        new TaskClass("Measure", List.of(field("point", ValueType.Simple.POINT)), ""),
                        new TaskClass("Look", List.of(field("location", ValueType.Simple.POINT)), "")));
    }

    private static void addDecisions(List<EventType> events) {
        events.add(asking(
                "Approve",
                decision(DecisionForm.APPROVE, "Yes", "No", 0, AnswerNames.NOBODY, AutonomyAnswer.YES),
                field("question", ValueType.Simple.TEXT)));
        events.add(input("Yes", EventRole.NONE));
        events.add(input("No", EventRole.NONE));
        events.add(asking(
                "ApproveThem",
                decision(DecisionForm.APPROVE, "YesThem", "NoThem", 0, AnswerNames.ENTERING, AutonomyAnswer.NONE)));
        events.add(input("YesThem", EventRole.NONE));
        events.add(input("NoThem", EventRole.NONE));
        events.add(asking(
                "Choose",
                decision(DecisionForm.CHOOSE_PROXIES, "Chosen", "", 1, AnswerNames.CHOSEN, AutonomyAnswer.ALL)));
        events.add(asking(
                "ChooseSome",
                decision(DecisionForm.CHOOSE_PROXIES, "Chosen", "", 0, AnswerNames.CHOSEN, AutonomyAnswer.ALL)));
        events.add(input("Chosen", EventRole.NONE));
        events.add(asking(
                "Pick",
                new DecisionType(
                        DecisionForm.CHOOSE_OPTION,
                        "Picked",
                        "PickedNone",
                        0,
                        1,
                        "options",
                        Map.of("option", ".", "text", "text"),
                        AnswerNames.ENTERING,
                        AutonomyAnswer.FIRST),
                field("options", new ValueType.ListOf(new ValueType.Named("Choice")))));
        events.add(input(
                "Picked",
                EventRole.NONE,
                field("option", new ValueType.Named("Choice")),
                field("text", ValueType.Simple.TEXT)));
        events.add(input("PickedNone", EventRole.NONE));
        events.add(asking(
                "Provide", decision(DecisionForm.PROVIDE, "Provided", "", 0, AnswerNames.NOBODY, AutonomyAnswer.NONE)));
        events.add(input("Provided", EventRole.NONE, field("number", ValueType.Simple.INTEGER)));
        events.add(asking(
                "Redefine",
                decision(
                        DecisionForm.REDEFINE_VARIABLE,
                        "Redefined",
                        "",
                        0,
                        AnswerNames.NOBODY,
                        AutonomyAnswer.DEFAULTS),
                field("variable", ValueType.Simple.VARIABLE)));
        events.add(input("Redefined", EventRole.NONE));
    }

    private static void addRoles(List<EventType> events) {
        FieldType name = field("interruptName", ValueType.Simple.TEXT);
        FieldType duration = field("duration", ValueType.Simple.DURATION);
        events.add(output("StartTimer", List.of("TimerExpired"), EventRole.TIMER, duration));
        events.add(input("TimerExpired", EventRole.TIMER_EXPIRED));
        events.add(output("StartProxyTimer", List.of("ProxyTimerExpired"), EventRole.PROXY_TIMER, duration));
        events.add(input("ProxyTimerExpired", EventRole.PROXY_TIMER_EXPIRED));
        events.add(output("GetAll", List.of("GotAll"), EventRole.GET_ALL_TOKENS));
        events.add(input("GotAll", EventRole.TOKENS_RETURNED));
        events.add(input("Interrupt", EventRole.INTERRUPT, name));
        events.add(output("GeneralInterrupt", List.of("GeneralInterruptReceived"), EventRole.GENERAL_INTERRUPT, name));
        events.add(input("GeneralInterruptReceived", EventRole.GENERAL_INTERRUPT_RECEIVED));
        events.add(output("ProxyInterrupt", List.of("ProxyInterruptReceived"), EventRole.PROXY_INTERRUPT, name));
        events.add(input("ProxyInterruptReceived", EventRole.PROXY_INTERRUPT_RECEIVED));
        events.add(output("AbortMission", List.of(), EventRole.ABORT_MISSION));
        events.add(input("AbortReceived", EventRole.ABORT_RECEIVED));
        events.add(output("CompleteMission", List.of(), EventRole.COMPLETE_MISSION));
        events.add(input("CompleteReceived", EventRole.COMPLETE_RECEIVED));
        events.add(input("SubMissionAborted", EventRole.SUB_MISSION_ABORTED));
        events.add(output("ReturnValue", List.of(), EventRole.RETURN_VALUE, field("value", ValueType.Simple.TEXT)));
        events.add(input(
                "CheckReturn",
                EventRole.CHECK_RETURN,
                field("value", ValueType.Simple.TEXT),
                field("subMission", ValueType.Simple.PLAN)));
        events.add(output(
                "GenerateTasks",
                List.of("TasksGenerated"),
                EventRole.GENERATE_TASKS,
                field("locations", new ValueType.ListOf(ValueType.Simple.POINT)),
                field("taskClass", ValueType.Simple.TEXT)));
        events.add(input("TasksGenerated", EventRole.TASKS_GENERATED));
        events.add(output(
                "ApplyAllocation",
                List.of(),
                EventRole.APPLY_ALLOCATION,
                field("tasks", new ValueType.MapOf(ValueType.Simple.TASK, ValueType.Simple.PROXY))));
    }

    private static DecisionType decision(
            DecisionForm form, String yes, String no, int min, AnswerNames names, AutonomyAnswer autonomy) {
        return new DecisionType(form, yes, no, min, Integer.MAX_VALUE, "", Map.of(), names, autonomy);
    }

    private static EventType asking(String name, DecisionType decision, FieldType... fields) {
        Set<String> answers = new LinkedHashSet<>();
        answers.add(decision.accepted());
        if (!decision.rejected().isEmpty()) {
            answers.add(decision.rejected());
        }
        return new EventType(
                name,
                List.of(),
                Direction.OUTPUT,
                List.of(fields),
                TokenNeed.NONE,
                List.copyOf(answers),
                EventRole.NONE,
                Set.of(),
                Optional.of(decision),
                name,
                "");
    }

    private static EventType output(String name, List<String> answers, EventRole role, FieldType... fields) {
        return new EventType(
                name,
                List.of(),
                Direction.OUTPUT,
                List.of(fields),
                TokenNeed.NONE,
                answers,
                role,
                Set.of(),
                Optional.empty(),
                name,
                "");
    }

    private static EventType input(String name, EventRole role, FieldType... fields) {
        return new EventType(
                name,
                List.of(),
                Direction.INPUT,
                List.of(fields),
                TokenNeed.NONE,
                List.of(),
                role,
                Set.of(),
                Optional.empty(),
                name,
                "");
    }

    private static FieldType field(String name, ValueType type) {
        return new FieldType(name, type, "", false, Optional.empty(), "");
    }
}
