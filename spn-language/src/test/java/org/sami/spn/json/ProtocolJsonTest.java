package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Project;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

class ProtocolJsonTest {
    private static final JsonMapper MAPPER = new JsonMapper();
    private static final TaskId TASK = new TaskId(3, "A/~ b");

    static List<Input> everyKindOfInput() {
        Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
        allocation.put(TASK, Optional.of("b1"));
        allocation.put(new TaskId(3, "B"), Optional.empty());
        Map<String, Value> values = new LinkedHashMap<>();
        values.put("z", new RealValue(-0.0));
        values.put("a.b/c", GeoPoint.of(1.5, 2));
        return List.of(
                new Input.StartMission("clv", "", values),
                new Input.LoadProject("{\"formatVersion\": 1}\n"),
                new Input.Received(new Occurrence("A", 1, 2, List.of("b2", "b1"), List.of(TASK), values)),
                new Input.Received(Occurrence.news("News", List.of(), Map.of())),
                new Input.ProxyJoined("b1"),
                new Input.ProxyDropped("b1", 0),
                new Input.TimeReached(),
                new Input.Interrupt(4, "stop", List.of("b1")),
                new Input.AbortMission(0),
                new Input.CompleteMission(Long.MAX_VALUE),
                new Input.AnswerDecision(1, new Answer.YesNo(false), Answerer.OPERATOR),
                new Input.AnswerDecision(1, new Answer.Proxies(List.of("b2", "b1")), Answerer.AUTONOMY),
                new Input.AnswerDecision(1, new Answer.Option(2), Answerer.OPERATOR),
                new Input.AnswerDecision(1, new Answer.Rejected(), Answerer.OPERATOR),
                new Input.AnswerDecision(1, new Answer.Fields(values), Answerer.OPERATOR),
                new Input.SetVariable(0, "@x", new IntegerValue(1)),
                new Input.AllocateTasks(allocation),
                new Input.AddTasks(2, List.of(new TaskSpec("T1", "Camera", values))),
                new Input.HandlerFailed(7, "no such robot"),
                new Input.Remember(1, "progress", new TextValue("half")),
                new Input.AskOperator("BoatRestarted", "b1", "May it move?", Priority.CRITICAL),
                new Input.AskOperator("BoatRestarted", "b1 b2", "Which?", Priority.CRITICAL, List.of("b1", "b2")),
                new Input.AskOperator(
                        "LongWay",
                        "1 2",
                        "Send it?",
                        Priority.HIGH,
                        List.of(),
                        Optional.of(new Input.AskOperator.Unanswered(false, 90_000))),
                new Input.HoldDecision(3),
                new Input.WithdrawQuestion("BoatRestarted", "b1"));
    }

    @Test
    void everyKindOfInputIsTried() {
        assertThat(everyKindOfInput())
                .extracting(Object::getClass)
                .extracting(Class::getSimpleName)
                .contains(Stream.of(Input.class.getPermittedSubclasses())
                        .map(Class::getSimpleName)
                        .toArray(String[]::new));
    }

    @ParameterizedTest
    @MethodSource("everyKindOfInput")
    void inputComesBackExactly(Input input) throws Exception {
        Input back = ProtocolJson.readInput(ProtocolJson.inputText(input));

        assertThat(back).isEqualTo(input);
        assertThat(ProtocolJson.inputText(back)).isEqualTo(ProtocolJson.inputText(input));
    }

    @ParameterizedTest
    @MethodSource("everyKindOfInput")
    void theTextOfAnInputIsThatOfItsTree(Input input) throws Exception {
        assertThat(ProtocolJson.inputText(input)).isEqualTo(MAPPER.writeValueAsString(ProtocolJson.input(input)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "a \"quoted\\ name",
                "\u0000\u001f\u007f\u0085",
                "Bo\u00f6t \u2028 \ud83d\ude80",
                "lone \ud83d",
                "</a>/'"
            })
    void theTextOfAnOccurrenceIsThatOfItsTreeWhateverNamesAreInIt(String name) throws Exception {
        Input input = new Input.Received(new Occurrence(
                name,
                Long.MIN_VALUE,
                -1,
                List.of(name, "b2"),
                List.of(new TaskId(0, name), new TaskId(Long.MAX_VALUE, "T")),
                Map.of(name, new TextValue(name))));

        assertThat(ProtocolJson.inputText(input)).isEqualTo(MAPPER.writeValueAsString(ProtocolJson.input(input)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "[]",
                "{\"input\":\"dance\"}",
                "{\"input\":\"proxy-joined\"}",
                "{\"input\":\"proxy-joined\",\"proxy\":\"a\",\"more\":1}",
                "{\"input\":\"abort-mission\",\"mission\":\"1\"}",
                "{\"input\":\"answer-decision\",\"decision\":1,\"by\":\"operator\",\"answer\":{}}",
                "{\"input\":\"remember\",\"mission\":1,\"key\":\"k\"}",
                "{\"input\":\"remember\",\"mission\":1,\"key\":\"k\",\"value\":{\"real\":\"x\"}}"
            })
    void strangeInputIsRefusedWithItsReason(String text) {
        assertThatThrownBy(() -> ProtocolJson.readInput(text)).isInstanceOf(UnreadableJsonException.class);
    }

    @Test
    void effectsAreWrittenWithTheirKind() {
        Activation activation = new Activation(
                5,
                2,
                1,
                9,
                "clv",
                "execute",
                "go",
                "ProxyExecutePath",
                Map.of("x", new RealValue(1)),
                Map.of(TASK, Map.of("location", GeoPoint.of(1, 2))),
                List.of(new Token.Proxy("b1"), new Token.Task(TASK), Token.GENERIC),
                Map.of(TASK, "b1"),
                List.of(new MarkupSpec("Priority", Map.of("rank", new EnumValue("Rank", "HIGH")))),
                Priority.HIGH);
        Decision decision = new Decision(
                1,
                2,
                5,
                "OperatorApprove",
                "End?",
                new Question.FillIn(List.of(new Question.Item(
                        "a.b", ValueType.Simple.REAL, "m", Optional.of(new RealValue(10)), true, "How far"))),
                Optional.of(new Answer.YesNo(true)),
                OptionalLong.of(1000),
                Priority.MEDIUM,
                List.of());
        List<Effect> effects = List.of(
                new Effect.MissionStarted(1, 0, "", "clv", "x"),
                new Effect.ProjectLoaded(2, new Project("lake", "", "test", List.of(), List.of(), List.of())),
                new Effect.Fired(
                        1,
                        1,
                        "t",
                        List.of(Occurrence.news("N", List.of(), Map.of())),
                        List.of(new TokenMove(Token.GENERIC, Optional.of("a"), Optional.empty()))),
                new Effect.Activated(activation),
                new Effect.ActivationEnded(5),
                new Effect.DecisionOpened(decision),
                new Effect.DecisionClosed(1, Optional.empty(), Optional.empty()),
                new Effect.DecisionHeld(2),
                new Effect.CommandsWithdrawn(1, List.of("b1")),
                new Effect.QuestionAnswered("BoatRestarted", "b1", true),
                new Effect.TasksAllocated(Map.of(TASK, Optional.of("b2")), Map.of(TASK, "b1"), Priority.HIGH),
                new Effect.VariableWritten(0, "@x", new RealValue(2)),
                new Effect.Noted(NoteKind.LATE, 1, "late"),
                new Effect.Entered(1, "b", 3, List.of(new Token.Proxy("b1"))),
                new Effect.Left(1, "a", 2, List.of()),
                new Effect.MissionEnded(1, Outcome.ENDED));

        List<String> written =
                effects.stream().map(e -> ProtocolJson.effect(e).toString()).toList();

        assertThat(effects.stream().map(e -> e.getClass().getSimpleName()))
                .containsExactlyInAnyOrderElementsOf(Stream.of(Effect.class.getPermittedSubclasses())
                        .map(Class::getSimpleName)
                        .toList());
        assertThat(written).allMatch(text -> text.startsWith("{\"effect\":\""));
        assertThat(written)
                .contains("{\"effect\":\"tasks-allocated\",\"priority\":\"high\",\"tasks\":[{\"task\":"
                        + "{\"mission\":" + TASK.mission() + ",\"name\":\"" + TASK.name()
                        + "\"},\"proxy\":\"b2\",\"before\":\"b1\"}]}");
        assertThat(written.get(1)).isEqualTo("{\"effect\":\"project-loaded\",\"version\":2,\"project\":\"lake\"}");
        assertThat(written.get(2))
                .isEqualTo("{\"effect\":\"fired\",\"firing\":1,\"mission\":1,\"transition\":\"t\","
                        + "\"used\":[{\"type\":\"N\"}],\"moves\":[{\"token\":\"generic\",\"from\":\"a\"}]}");
        assertThat(written)
                .contains(
                        "{\"effect\":\"entered\",\"mission\":1,\"place\":\"b\",\"visit\":3,\"tokens\":[{\"proxy\":\"b1\"}]}",
                        "{\"effect\":\"left\",\"mission\":1,\"place\":\"a\",\"visit\":2,\"tokens\":[]}");
        assertThat(written.get(5)).contains("\"deadlineMillis\":1000").contains("\"ask\":\"fill-in\"");
    }
}
