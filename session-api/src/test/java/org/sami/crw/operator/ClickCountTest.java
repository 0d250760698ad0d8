package org.sami.crw.operator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** The table of docs/clicks.md. */
class ClickCountTest {
    private static final GeoPoint A = GeoPoint.of(45, 10);
    private static final GeoPoint B = GeoPoint.of(45, 10.001);
    private static final GeoPoint C = GeoPoint.of(45.001, 10);

    private final ClickCount count = new ClickCount();

    @Test
    void buttonsAreOneClickEach() {
        assertClicks(new Input.StartMission("clv", "", Map.of()), 1);
        assertClicks(new Input.AbortMission(1), 1);
        assertClicks(new Input.CompleteMission(1), 1);
        assertClicks(new Input.Interrupt(1, "Recharge", List.of()), 1);
        assertClicks(new Input.Interrupt(1, "Recharge", List.of("boat-1")), 2);
        assertClicks(answered(new Answer.YesNo(false)), 1);
        assertClicks(answered(new Answer.Option(0)), 1);
        assertClicks(answered(new Answer.Rejected()), 1);
    }

    @Test
    void interruptThatIsRefusedIsNoClick() {
        Input press = new Input.Interrupt(1, "Recharge", List.of("boat-1"));

        count.count(press, List.of(new Effect.Noted(NoteKind.INTERRUPT_REFUSED, 1, "Nobody is there")));

        assertThat(count.clicks()).isZero();
    }

    @Test
    void eachBoatAndEachLocationIsOneAndTheConfirmationToo() {
        assertClicks(answered(new Answer.Proxies(List.of("a", "b", "c"))), 4);
        assertClicks(fields(new ListValue(List.of(A, B))), 3);
        assertClicks(fields(new GeoPath(List.of(A, B, C))), 4);
        assertClicks(fields(new GeoArea(List.of(A, B, C), List.of())), 4);
        assertClicks(fields(A), 2);
        assertClicks(fields(new RealValue(5)), 1);
    }

    @Test
    void whatIsLeftAtItsDefaultIsNoClick() {
        Question.Item item =
                new Question.Item("where", ValueType.Simple.POINT, "", Optional.of(A), true, "Where to gather");
        count.count(new Input.TimeReached(), List.of(new Effect.DecisionOpened(decision(item))));

        assertClicks(fields(A), 1);
        assertClicks(fields(B), 2);
    }

    @Test
    void autonomyAndBoatsDoNotClick() {
        assertClicks(new Input.AnswerDecision(5, new Answer.Proxies(List.of("a")), Answerer.AUTONOMY), 0);
        assertClicks(new Input.ProxyJoined("a"), 0);
        assertClicks(new Input.TimeReached(), 0);
    }

    private void assertClicks(Input input, long expected) {
        long before = count.clicks();
        count.count(input, List.of());
        assertThat(count.clicks() - before).as(input.toString()).isEqualTo(expected);
    }

    private static Input fields(Value value) {
        return answered(new Answer.Fields(Map.of("where", value)));
    }

    private static Input answered(Answer answer) {
        return new Input.AnswerDecision(5, answer, Answerer.OPERATOR);
    }

    private static Decision decision(Question.Item item) {
        return new Decision(
                5,
                1,
                0,
                "",
                "Where?",
                new Question.FillIn(List.of(item)),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of());
    }
}
