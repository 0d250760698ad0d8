package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.ValueType;

/** Tokens, requirements, visits, when a transition is looked at, firing (R-TOK-*, R-OUT-*, R-VIS-*, R-LOOK-*, R-FIRE-*). */
class RulesOfFiringTest {
    @Test
    void aRootMissionStartsWithOneGenericItsRobotsAndItsTasks() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .task("T1", "Measure", Map.of())
                .task("T2", "Look", Map.of())
                .build());
        s.join("A", "B");

        long m = s.start("net");

        assertThat(s.marking(m, "s")).isEqualTo("generic A B #T1 #T2");
    }

    @Test
    void aRobotThatJoinsLaterEntersOnlyByAnOccurrenceThatNamesIt() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .places("x")
                .transition("t", "News")
                .in("s", "t", "generic >= 1")
                .out("t", "x", "add all relevant")
                .build());
        long m = s.join("A").start("net");

        s.join("B");
        assertThat(s.marking(m).toString()).doesNotContain("B");
        s.news("News", "B");

        assertThat(s.marking(m, "x")).isEqualTo("B");
    }

    @Test
    void twoEdgesThatTakeOneForkOneToken() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t")
                .in("s", "t", "generic >= 1")
                .out("t", "x", "take 1 generic", "take 1 proxy")
                .out("t", "y", "take 1 generic", "take 1 proxy")
                .build());

        long m = s.join("A", "B").start("net");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "B", "x", "generic A", "y", "generic A"));
    }

    @Test
    void oneEdgeAddsATokenOnce() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t", "News")
                .in("s", "t", "relevant all")
                .out("t", "x", "add all relevant", "take all proxy", "take 1 any")
                .build());
        long m = s.join("A", "B").start("net");

        s.news("News", "B");

        assertThat(s.marking(m, "x")).isEqualTo("B A generic");
    }

    @Test
    void whatIsMissingIsRecordedAndTheRestMoves() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t")
                .in("s", "t", "generic >= 1")
                .out("t", "x", "take 3 proxy", "take 1 generic")
                .build());

        long m = s.join("A").start("net");

        assertThat(s.marking(m, "x")).isEqualTo("A generic");
        assertThat(s.notes()).containsExactly(NoteKind.SHORT_OF_TOKENS);
    }

    @Test
    void anUnconditionalOutEdgeEntersItsPlaceWithNobody() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("x", "Do")
                .transition("t")
                .in("s", "t", "always")
                .out("t", "x", "always")
                .transition("after", "Done")
                .in("x", "after", "always")
                .out("after", "y", "add 1 generic")
                .build());
        long m = s.start("net");

        assertThat(s.latest("x").tokens()).isEmpty();
        s.answer("Done", "x");
        assertThat(s.marking(m, "y")).isEqualTo("generic");

        s.answer("Done", s.latest("x"));
        assertThat(s.notes()).containsExactly(NoteKind.LATE);
    }

    @Test
    void twoSiblingsBehindUnconditionalEdgesBothFireForOneEntry() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t1")
                .in("s", "t1", "always")
                .out("t1", "x", "take 1 generic")
                .transition("t2")
                .in("s", "t2", "always")
                .out("t2", "y", "add 1 generic")
                .build());

        s.start("net");

        assertThat(s.fired()).containsExactly("t1", "t2");
    }

    @Test
    void theLoserOfAConflictDoesNotFire() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t1")
                .in("s", "t1", "generic >= 1")
                .out("t1", "x", "take 1 generic")
                .transition("t2")
                .in("s", "t2", "generic >= 1")
                .out("t2", "y", "take 1 generic")
                .build());

        long m = s.start("net");

        assertThat(s.fired()).containsExactly("t1");
        assertThat(s.marking(m)).isEqualTo(Map.of("x", "generic"));
    }

    @Test
    void thePlansOrderOfOutTransitionsDecides() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .order("s", "t2", "t1")
                .transition("t1")
                .in("s", "t1", "generic >= 1")
                .out("t1", "x", "take 1 generic")
                .transition("t2")
                .in("s", "t2", "generic >= 1")
                .out("t2", "y", "take 1 generic")
                .build());

        s.start("net");

        assertThat(s.fired()).containsExactly("t2");
    }

    @Test
    void leavingATokenLooksAtInhibitedTransitions() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("go", "News")
                .in("s", "go", "relevant all")
                .out("go", "x", "take all relevant")
                .transition("empty")
                .in("s", "empty", "proxy = 0", "generic >= 1")
                .out("empty", "y", "take 1 generic")
                .build());
        long m = s.join("A", "B").start("net");

        s.news("News", "A");
        assertThat(s.fired()).containsExactly("go");
        s.news("News", "B");

        assertThat(s.fired()).containsExactly("go", "empty");
        assertThat(s.marking(m, "y")).isEqualTo("generic");
    }

    @Test
    void aTransitionFiresAgainWhileItsOwnFiringRemovesWhatItCounts() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t")
                .in("s", "t", "proxy >= 1")
                .out("t", "x", "take 1 proxy")
                .build());

        long m = s.join("A", "B", "C").start("net");

        assertThat(s.fired()).containsExactly("t", "t", "t");
        assertThat(s.marking(m, "x")).isEqualTo("A B C");
    }

    @Test
    void nothingElseMakesItFireAgain() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t")
                .in("s", "t", "proxy >= 1")
                .out("t", "x", "add 1 proxy")
                .build());

        s.join("A").start("net");

        assertThat(s.fired()).containsExactly("t");
    }

    @Test
    void aRingWithoutEventsIsALivelockAndItsMarkingStays() {
        NetBuilder net = new NetBuilder("net").start("p0");
        for (int i = 0; i < 3; i++) {
            net.transition("t" + i)
                    .in("p" + i, "t" + i, "generic >= 1")
                    .out("t" + i, "p" + (i + 1) % 3, "take 1 generic");
        }
        Session s = new Session(new Engine(TestVocabulary.TEST, NetBuilder.project(net.build()), 100));

        long m = s.start("net");

        assertThat(s.fired()).hasSize(100);
        assertThat(s.notes()).containsExactly(NoteKind.LIVELOCK);
        assertThat(s.outcome(m)).contains(Outcome.HALTED);
        assertThat(s.view().mission(m).orElseThrow().status()).isEqualTo(MissionStatus.HALTED);
        assertThat(s.marking(m)).isEqualTo(Map.of("p1", "generic"));
        s.step(new Input.AbortMission(m));
        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
    }

    @Test
    void tokensThatCopyThemselvesAreStoppedLongBeforeTheyFillTheMemory() {
        Session s = new Session(new Engine(
                TestVocabulary.TEST,
                NetBuilder.project(new NetBuilder("net")
                        .start("p")
                        .transition("t")
                        .in("p", "t", "generic >= 1")
                        .out("t", "p", "add all generic")
                        .build()),
                100));

        long m = s.start("net");

        assertThat(s.notes()).containsExactly(NoteKind.LIVELOCK);
        assertThat(s.outcome(m)).contains(Outcome.HALTED);
        assertThat(s.fired())
                .as("1024 tokens are more than ten for each of 100 firings")
                .hasSize(10);
    }

    @Test
    void aPlanThatStartsItselfIsStopped() {
        Session s = new Session(new NetBuilder("net").start("s").sub("s", "net").build());

        s.start("net");

        assertThat(s.notes()).contains(NoteKind.LIVELOCK);
    }

    @Test
    void enteringAnEndPlaceEndsTheMissionAfterTheFiringIsComplete() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output(
                        "s",
                        "StartTimer",
                        Map.of("duration", new FieldSource.Fixed(new org.sami.spn.value.DurationValue(1000))),
                        Map.of())
                .output("s", "Approve")
                .end("e")
                .output("e", "Do")
                .output("e", "Approve")
                .transition("t", "News")
                .in("s", "t", "always")
                .out("t", "e", "consume all proxy")
                .out("t", "x", "take 1 generic")
                .output("x", "Do")
                .transition("again")
                .in("x", "again", "generic >= 1")
                .out("again", "s", "take 1 generic")
                .build());
        long m = s.join("A").start("net");

        s.news("News");

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.activations("e")).hasSize(2);
        assertThat(s.activations("x")).hasSize(1);
        assertThat(s.outcome(m)).contains(Outcome.ENDED);
        assertThat(s.view().decisions()).isEmpty();
        assertThat(s.view().nextDueMillis()).isEmpty();
        assertThat(s.view().openActivations()).isEmpty();
        s.answer("Done", s.latest("e"));
        s.news("News");
        s.advance(5000);
        assertThat(s.allFired()).containsExactly("t");
    }

    @Test
    void activationsCarryExactlyTheTokensThatEntered() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("x", "Do")
                .transition("t", "News")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        s.join("A", "B", "C").start("net");

        s.news("News", "B");
        assertThat(s.latest("x").proxies()).containsExactly("B");
        s.news("News", "A", "C");

        assertThat(s.latest("x").proxies()).containsExactly("A", "C");
        assertThat(s.activations("x")).extracting(Activation::visit).doesNotHaveDuplicates();
    }

    @Test
    void fieldsAreResolvedAtEntryAndStayAsTheyWere() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .variable("@n", ValueType.Simple.INTEGER, new IntegerValue(1))
                .output("s", "Do", Map.of("number", new FieldSource.FromVariable("@n")), Map.of())
                .build());
        long m = s.start("net");

        s.step(new Input.SetVariable(m, "@n", new IntegerValue(2)));

        assertThat(s.view().openActivations().get(0).value("number")).contains(new IntegerValue(1));
    }

    @Test
    void taskFieldsAreReadFromEachEnteringTask() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .task("T1", "Measure", Map.of("number", new IntegerValue(7)))
                .task("T2", "Measure", Map.of("number", new IntegerValue(8)))
                .output("s", "Do", Map.of("number", new FieldSource.FromTask()), Map.of())
                .build());

        long m = s.start("net");

        assertThat(s.latest("s").taskValues())
                .isEqualTo(Map.of(
                        new TaskId(m, "T1"), Map.of("number", new IntegerValue(7)),
                        new TaskId(m, "T2"), Map.of("number", new IntegerValue(8))));
    }

    @Test
    void constantsAreWrittenBeforeTheStartMarking() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .variable("@n", ValueType.Simple.INTEGER)
                .output("s", "Do", Map.of("number", new FieldSource.FromVariable("@n")), Map.of())
                .output(
                        "later",
                        "Do",
                        Map.of("number", new FieldSource.Fixed(new IntegerValue(5))),
                        Map.of("number", "@n"))
                .build());

        s.start("net");

        assertThat(s.latest("s").value("number")).contains(new IntegerValue(5));
    }

    @Test
    void anInputEventWritesItsVariableWhenTheTransitionFires() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .variable("@n", ValueType.Simple.INTEGER)
                .input("t", "News", Map.of(), Map.of("value", "@n"))
                .in("s", "t", "always")
                .out("t", "x", "take 1 generic")
                .build());
        long m = s.start("net");

        s.step(new Input.Received(Occurrence.news("News", List.of(), Map.of("value", new IntegerValue(3)))));

        assertThat(s.view().variable(m, "@n")).isEqualTo(Optional.of(new IntegerValue(3)));
        assertThat(s.last()).anyMatch(Effect.VariableWritten.class::isInstance);
    }

    @Test
    void aDroppedRobotLeavesAndNobodyWaitsForIt() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Do")
                .transition("t", "Done")
                .waitForAll("t")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        long m = s.join("A", "B").start("net");
        s.answer("Done", "s", "A");

        s.step(new Input.ProxyDropped("B", m));

        assertThat(s.fired()).containsExactly("t");
        assertThat(s.marking(m, "x")).isEqualTo("A");
        assertThat(s.last()).contains(new Effect.CommandsWithdrawn(m, List.of("B")));
    }

    @Test
    void aDropOfARobotThatNobodyKnowsIsRefusedAndChangesNothing() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("t", "News")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        long m = s.join("A").start("net");
        s.step(new Input.ProxyDropped("A", Ids.NONE));

        s.step(new Input.ProxyDropped("A", Ids.NONE));

        assertThat(s.last())
                .containsExactly(new Effect.Noted(NoteKind.REJECTED_INPUT, Ids.NONE, "No robot 'A' is known"));
        assertThat(s.marking(m, "s")).isEqualTo("generic");
    }
}
