package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

/** A state's key says what the state means, not how it came about. */
class StateKeyTest {
    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("e")
            .transition("done", "Done")
            .in("c", "done", "relevant all")
            .out("done", "e", "take all relevant")
            .build();

    /** Robots go to the left, where a question waits for them, to the right, where a timer runs, or into a sub-mission. */
    private static final Plan MAIN = new NetBuilder("main")
            .start("s")
            .output("s", "Do")
            .variable("@n", ValueType.Simple.INTEGER, new IntegerValue(1))
            .task("T", "Measure", Map.of("point", GeoPoint.of(1, 2)))
            .transition("toLeft", "News")
            .in("s", "toLeft", "relevant all")
            .out("toLeft", "left", "take all relevant")
            .output("left", "Approve")
            .transition("toRight", "Other")
            .in("s", "toRight", "relevant all")
            .out("toRight", "right", "take all relevant")
            .output("right", "StartTimer", Map.of("duration", new FieldSource.Fixed(new DurationValue(5000))), Map.of())
            .transition("toSub", "Done2")
            .in("s", "toSub", "relevant all")
            .out("toSub", "sub", "take all relevant")
            .sub("sub", "child")
            .transition("kept", "Done", "Failed")
            .in("s", "kept", "relevant all")
            .out("kept", "k", "take all relevant")
            .build();

    private static Session session() {
        Session s = new Session(MAIN, CHILD);
        s.join("A", "B", "C").start("main");
        return s;
    }

    private static StateKey key(Session s) {
        return StateKey.of(s.state());
    }

    private static byte[] bytes(Session s) {
        return StateCodec.encode(s.state());
    }

    @Test
    void independentNewsInAnotherOrderLeadToTheSameState() {
        Session one = session();
        one.news("News", "A");
        one.news("Other", "B");
        Session other = session();
        other.news("Other", "B");
        other.news("News", "A");

        assertThat(bytes(one)).as("visits and activations have other ids").isNotEqualTo(bytes(other));
        assertThat(key(one)).isEqualTo(key(other)).hasSameHashCodeAs(key(other));
    }

    @Test
    void pendingAnswersOfTwoEventsInAnotherOrderAreTheSameState() {
        Session one = session();
        one.answer("Done", "s", "A");
        one.answer("Failed", "s", "B");
        Session other = session();
        other.answer("Failed", "s", "B");
        other.answer("Done", "s", "A");

        assertThat(key(one)).isEqualTo(key(other));
    }

    @Test
    void orderOfEntryIntoOnePlaceIsPartOfTheState() {
        Session one = session();
        one.news("News", "A");
        one.news("News", "B");
        Session other = session();
        other.news("News", "B");
        other.news("News", "A");

        assertThat(key(one)).isNotEqualTo(key(other));
    }

    @Test
    void missionsThatStartedInAnotherOrderAreTheSameState() {
        Session one = new Session(MAIN, CHILD);
        one.join("A").start("main");
        one.start("child");
        one.answer("Done2", "s", "A");
        Session other = new Session(MAIN, CHILD);
        other.join("A").start("child");
        other.start("main");
        other.answer("Done2", "s", "A");

        assertThat(key(one)).isEqualTo(key(other));
    }

    @Test
    void whoHearsNewsFirstIsPartOfTheStateWhereGlobalsCanBeWritten() {
        Project project = NetBuilder.project(
                List.of(new VariableSpec("@g", ValueType.Simple.INTEGER, java.util.Optional.empty())), MAIN, CHILD);
        Session one = new Session(project);
        one.start("main");
        one.start("child");
        Session other = new Session(project);
        other.start("child");
        other.start("main");

        assertThat(key(one)).isNotEqualTo(key(other));
    }

    @Test
    void decisionsThatWereOpenedInAnotherOrderAreTheSameState() {
        Session one = session();
        one.step(question("Restarted", "A"));
        one.step(question("Lost", "B"));
        one.step(new Input.Remember(1, "x", new IntegerValue(1)));
        one.step(new Input.Remember(1, "y", new IntegerValue(2)));
        Session other = session();
        other.step(question("Lost", "B"));
        other.step(question("Restarted", "A"));
        other.step(new Input.Remember(1, "y", new IntegerValue(2)));
        other.step(new Input.Remember(1, "x", new IntegerValue(1)));

        assertThat(bytes(one)).isNotEqualTo(bytes(other));
        assertThat(key(one)).isEqualTo(key(other));
    }

    private static Input question(String kind, String about) {
        return new Input.AskOperator(kind, about, kind + "?", Priority.MEDIUM);
    }

    @Test
    void laterAndWithOtherIdsItIsTheSameState() {
        Session fresh = session();
        fresh.news("Other", "A");
        fresh.advance(2000);
        fresh.answer("Done2", "s", "B");
        fresh.step(allocation(1));
        fresh.step(new Input.Remember(Ids.NONE, "task", new TaskId(1, "T")));

        Session used = new Session(MAIN, CHILD);
        used.join("A", "B", "C");
        used.start("main");
        used.news("Other", "C");
        used.answer("Done2", "s", "B");
        used.advance(777);
        used.step(new Input.AbortMission(1));
        long mission = used.start("main");
        used.news("Other", "A");
        used.advance(2000);
        used.answer("Done2", "s", "B");
        used.step(allocation(mission));
        used.step(new Input.Remember(Ids.NONE, "task", new TaskId(mission, "T")));

        assertThat(mission).isGreaterThan(1);
        assertThat(key(used)).isEqualTo(key(fresh)).hasSameHashCodeAs(key(fresh));
        assertThat(key(used).bytes()).isEqualTo(key(fresh).bytes());
    }

    private static Input allocation(long mission) {
        return new Input.AllocateTasks(Map.of(new TaskId(mission, "T"), java.util.Optional.of("C")));
    }

    static Stream<Arguments> differences() {
        return Stream.of(
                difference("another robot moved", s -> s.news("News", "A"), s -> s.news("News", "B")),
                difference("it moved elsewhere", s -> s.news("News", "A"), s -> s.news("Other", "A")),
                difference("a pending answer", s -> {}, s -> s.answer("Done", "s", "A")),
                difference(
                        "whom a pending answer names",
                        s -> s.answer("Done", "s", "A"),
                        s -> s.answer("Done", "s", "B")),
                difference("a timer's remaining time", s -> s.news("Other", "A"), s -> {
                    s.news("Other", "A");
                    s.advance(1);
                }),
                difference("a variable", s -> {}, s -> s.step(new Input.SetVariable(1, "@n", new IntegerValue(2)))),
                difference("what is remembered", s -> {}, s -> s.step(new Input.Remember(1, "k", new TextValue("v")))),
                difference("who is known", s -> {}, s -> s.join("D")),
                difference("who a task is allocated to", s -> {}, s -> s.step(allocation(1))),
                difference("a question of the domain", s -> {}, s -> s.step(question("Lost", "A"))),
                difference("an answered decision", s -> s.news("News", "A"), s -> {
                    s.news("News", "A");
                    s.step(new Input.AnswerDecision(1, new Answer.YesNo(true), Answerer.OPERATOR));
                }),
                difference("what runs in a sub-mission", s -> s.answer("Done2", "s", "A"), s -> {
                    s.answer("Done2", "s", "A");
                    s.answer("Done", "c", "A");
                }),
                difference("a second mission", s -> {}, s -> s.start("main")),
                difference("a mission that ended", s -> {}, s -> s.step(new Input.AbortMission(1))));
    }

    private static Arguments difference(String what, Consumer<Session> one, Consumer<Session> other) {
        return Arguments.of(what, one, other);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("differences")
    void keysDifferBy(String what, Consumer<Session> one, Consumer<Session> other) {
        Session first = session();
        one.accept(first);
        Session second = session();
        other.accept(second);

        assertThat(key(first)).as(what).isNotEqualTo(key(second));
    }

    @Test
    void aCopyAndADecodedStateHaveTheSameKey() {
        Session s = session();
        s.news("Other", "A");
        s.answer("Done2", "s", "B");
        s.answer("Done", "s", "C");

        assertThat(StateKey.of(s.state().copy())).isEqualTo(key(s));
        assertThat(StateKey.of(StateCodec.decode(bytes(s), s.engine()))).isEqualTo(key(s));
        assertThat(key(s))
                .isEqualTo(key(s))
                .isNotEqualTo(StateKey.of(new Engine(TestVocabulary.TEST, NetBuilder.project(MAIN)).newState()));
    }
}
