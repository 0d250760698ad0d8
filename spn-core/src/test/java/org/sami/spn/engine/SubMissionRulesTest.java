package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Priority;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.ValueType;

/** Sub-missions, interrupts, aborts, variables (R-SUB-*, R-INT-*, R-END-*, R-VAR-*). */
class SubMissionRulesTest {
    /** Everybody works, then ends one by one; the instance ends with the first. */
    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .end("e")
            .transition("over", "Done")
            .in("c", "over", "relevant all")
            .out("over", "e", "take all relevant")
            .build();

    private static NetBuilder parent() {
        return new NetBuilder("parent")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "sub", "take all relevant")
                .sub("sub", "child");
    }

    private static NetBuilder taking() {
        return parent().transition("back").in("sub", "back", "proxy >= 1").out("back", "x", "take all sub");
    }

    @Test
    void aVisitStartsItsOwnInstanceAndItsTokensStayAndAreOutsideThePool() {
        Session s = new Session(taking().build(), CHILD);
        long m = s.join("A", "B").start("parent");

        s.news("News", "A");
        s.news("News", "B");

        assertThat(s.marking(m, "sub")).isEqualTo("A B");
        assertThat(s.view().missions()).hasSize(3);
        assertThat(s.allFired()).doesNotContain("back");
        assertThat(s.view().whyNotEnabled(m, "back").reasons()).anyMatch(r -> r.contains("not complete"));

        s.answer("Done", s.activations("c").get(1), "B");
        assertThat(s.fired()).containsExactly("over", "back");
        assertThat(s.marking(m, "sub")).isEqualTo("A");
        assertThat(s.marking(m, "x")).isEqualTo("B");
    }

    @Test
    void aStartingTokenThatDidNotComeBackStaysAndIsReported() {
        Session s = new Session(taking().build(), CHILD);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A", "B");

        s.answer("Done", "c", "A");

        assertThat(s.fired()).containsExactly("over", "back");
        assertThat(s.notes()).contains(NoteKind.NOT_RETURNED);
        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "sub", "B", "x", "A"));
    }

    @Test
    void aChildThatEndsAtOnceDoesNotHangItsParent() {
        Plan quick = new NetBuilder("child")
                .start("c")
                .end("e")
                .transition("over")
                .in("c", "over", "always")
                .out("over", "e", "take all any")
                .build();
        Session s = new Session(taking().build(), quick);
        long m = s.join("A", "B").start("parent");

        for (String robot : List.of("A", "B")) {
            s.news("News", robot);
        }

        assertThat(s.marking(m, "x")).isEqualTo("A B");
    }

    @Test
    void anInterruptTakesOneRobotOutOfTheRunningInstance() {
        Session s = new Session(
                taking().input("pull", "Interrupt", Map.of("interruptName", new TextValue("Recharge")), Map.of())
                        .in("sub", "pull", "relevant all")
                        .out("pull", "dock", "take all relevant")
                        .build(),
                CHILD);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A", "B");
        long child = s.idOf("child");

        s.press("Recharge", "A");
        assertThat(s.marking(child, "c")).isEqualTo("B");
        assertThat(s.marking(m, "dock")).isEqualTo("A");
        assertThat(s.last())
                .contains(
                        new Effect.CommandsWithdrawn(m, List.of("A")),
                        new Effect.CommandsWithdrawn(child, List.of("A")));
        s.press("Recharge", "B");

        assertThat(s.outcome(child)).contains(Outcome.ABORTED);
        assertThat(s.view().decisions()).isEmpty();
        assertThat(s.marking(m, "dock")).isEqualTo("A B");
        s.press("Recharge", "B");
        assertThat(s.notes()).isNotEmpty();
    }

    @Test
    void anInterruptIsNeverKept() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
                .in("x", "pull", "generic >= 1")
                .in("s", "pull", "always")
                .out("pull", "y", "take 1 generic")
                .transition("go", "News")
                .in("s", "go", "always")
                .out("go", "x", "take 1 generic")
                .build());
        long m = s.start("net");
        assertThat(s.view().interrupts()).containsExactly(new InterruptButton(m, "Stop", false));

        s.press("Stop");
        assertThat(s.notes()).containsExactly(NoteKind.INTERRUPT_REFUSED);
        s.news("News");
        assertThat(s.fired()).containsExactly("go");
        s.press("Stop");

        assertThat(s.fired()).containsExactly("pull");
    }

    @Test
    void anInterruptThatFindsNoMarkedPlaceIsRefusedAndTold() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .places("work")
                .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
                .in("work", "pull", "relevant >= 1")
                .out("pull", "y", "take all relevant")
                .build());
        long m = s.join("A").start("net");

        s.press("Stop", "A");

        assertThat(s.last()).singleElement().isInstanceOfSatisfying(Effect.Noted.class, note -> {
            assertThat(note.kind()).isEqualTo(NoteKind.INTERRUPT_REFUSED);
            assertThat(note.mission()).isEqualTo(m);
            assertThat(note.message()).contains("'Stop'").contains("A");
        });
    }

    @Test
    void aNamedInterruptWithoutInPlaceIsAButtonWhileItsMissionRuns() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .input("pull", "Interrupt", Map.of("interruptName", new TextValue("More")), Map.of())
                .out("pull", "y", "add 1 generic")
                .build());
        long m = s.start("net");

        s.press("More");
        s.press("More");

        assertThat(s.marking(m, "y")).isEqualTo("generic generic");
    }

    @Test
    void anInterruptPlaceAsksForTheRobotsUnlessThePressNamesThem() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output(
                        "button",
                        "ProxyInterrupt",
                        Map.of("interruptName", new FieldSource.Fixed(new TextValue("Pull"))),
                        Map.of())
                .transition("begin")
                .in("s", "begin", "always")
                .out("begin", "work", "take all proxy")
                .out("begin", "button", "take 1 generic")
                .transition("pull", "ProxyInterruptReceived")
                .in("button", "pull", "generic >= 1")
                .in("work", "pull", "relevant >= 1")
                .out("pull", "dock", "take all relevant")
                .build());
        long m = s.join("A", "B", "C").start("net");
        assertThat(s.view().interrupts()).containsExactly(new InterruptButton(m, "Pull", true));

        s.press("Pull");
        s.decide(new Answer.Proxies(List.of("B")));
        s.press("Pull", "A");

        assertThat(s.marking(m, "dock")).isEqualTo("B A");
        assertThat(s.marking(m, "work")).isEqualTo("C");
    }

    @Test
    void abortEndsAMissionAndAllDescendantsAndWithdrawsTheirCommands() {
        Session s = new Session(taking().build(), CHILD);
        long m = s.join("A").start("parent");
        s.news("News", "A");
        long child = s.idOf("child");

        s.step(new Input.AbortMission(m));

        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
        assertThat(s.outcome(child)).contains(Outcome.ABORTED);
        assertThat(s.last())
                .contains(new Effect.CommandsWithdrawn(m, List.of()), new Effect.CommandsWithdrawn(child, List.of()));
        assertThat(s.view().missions()).isEmpty();
        assertThat(s.view().openActivations()).isEmpty();
    }

    @Test
    void aTransitionMayInterceptAnAbort() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .transition("caught", "AbortReceived")
                .in("s", "caught", "generic >= 1")
                .out("caught", "home", "take all any")
                .build());
        long m = s.join("A").start("net");

        s.step(new Input.AbortMission(m));
        assertThat(s.marking(m, "home")).isEqualTo("generic A");
        s.step(new Input.AbortMission(m));

        assertThat(s.outcome(m)).contains(Outcome.ABORTED);
    }

    @Test
    void completeEndsAMissionAsCompleted() {
        Session s = new Session(CHILD);
        long m = s.join("A").start("child");

        s.step(new Input.CompleteMission(m));

        assertThat(s.outcome(m)).contains(Outcome.COMPLETED);
    }

    @Test
    void anAbortedChildIsAnOutcomeOfItsOwn() {
        Session s = new Session(
                taking().transition("aborted", "SubMissionAborted")
                        .in("sub", "aborted", "relevant all")
                        .out("aborted", "lost", "take all relevant")
                        .build(),
                CHILD);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A");

        s.step(new Input.AbortMission(s.idOf("child")));

        assertThat(s.fired()).containsExactly("aborted");
        assertThat(s.marking(m, "lost")).isEqualTo("A");
        assertThat(s.view().decisions()).isEmpty();
    }

    @Test
    void whereNobodyWaitsForAnAbortedChildTheOperatorDecides() {
        for (boolean giveBack : new boolean[] {true, false}) {
            Session s = new Session(taking().build(), CHILD);
            long m = s.join("A").start("parent");
            s.news("News", "A");
            s.step(new Input.AbortMission(s.idOf("child")));
            assertThat(s.allFired()).doesNotContain("back");
            assertThat(s.onlyDecision().automatic()).contains(new Answer.YesNo(true));

            s.decide(new Answer.YesNo(giveBack));

            assertThat(s.marking(m, giveBack ? "x" : "sub")).isEqualTo("A");
        }
    }

    @Test
    void whenOneOfSeveralVisitsByNobodyIsCompleteTheOthersGoOn() {
        Plan errand = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("e")
                .transition("over", "Done")
                .in("c", "over", "always")
                .out("over", "e", "always")
                .build();
        Plan sender = new NetBuilder("parent")
                .start("s")
                .transition("send", "News")
                .in("s", "send", "always")
                .out("send", "sub", "always")
                .sub("sub", "child")
                .transition("back")
                .in("sub", "back", "always")
                .out("back", "x", "add 1 generic")
                .build();
        Session s = new Session(sender, errand);
        long m = s.join("A").start("parent");
        s.news("News", "A");
        s.news("News", "A");

        s.answer("Done", s.activations("c").get(0));

        assertThat(s.fired()).containsExactly("over", "back");
        assertThat(s.view().missions()).as("parent and the second errand").hasSize(2);

        s.answer("Done", s.activations("c").get(1));
        assertThat(s.fired()).containsExactly("over", "back");
        assertThat(s.marking(m, "x")).isEqualTo("generic generic");
    }

    @Test
    void aStaticInstanceIsJoinedAndReturnsThroughItsEndPlaces() {
        Plan parent = new NetBuilder("parent")
                .start("s")
                .shared("sub", "child")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "sub", "take all relevant")
                .transition("back")
                .in("sub", "back", "proxy >= 1")
                .out("back", "x", "take all sub")
                .build();
        Session s = new Session(parent, CHILD);
        long m = s.join("A", "B").start("parent");
        long child = s.idOf("child");
        assertThat(s.marking(child)).isEmpty();

        s.news("News", "A");
        s.news("News", "B");
        assertThat(s.marking(child, "c")).isEqualTo("A B");
        List<Activation> asked = s.activations("c");
        s.answer("Done", asked.get(1), "B");
        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "sub", "A", "x", "B"));
        assertThat(s.marking(child)).isEqualTo(Map.of("c", "A"));
        s.answer("Done", asked.get(0), "A");

        assertThat(s.marking(m, "x")).isEqualTo("B A");
        assertThat(s.outcome(child)).isEmpty();
    }

    @Test
    void aReturnValueBelongsToTheInstance() {
        Plan child = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("good", "bad")
                .output("good", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("good"))), Map.of())
                .output("bad", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("bad"))), Map.of())
                .transition("ok", "Done")
                .in("c", "ok", "relevant all")
                .out("ok", "good", "take all relevant")
                .transition("nok", "Failed")
                .in("c", "nok", "relevant all")
                .out("nok", "bad", "take all relevant")
                .build();
        Session s = new Session(
                parent().input("yes", "CheckReturn", Map.of("value", new TextValue("good")), Map.of())
                        .in("sub", "yes", "always")
                        .out("yes", "x", "take all sub")
                        .input("no", "CheckReturn", Map.of("value", new TextValue("bad")), Map.of())
                        .in("sub", "no", "always")
                        .out("no", "y", "take all sub")
                        .build(),
                child);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A");
        s.news("News", "B");

        s.answer("Failed", s.activations("c").get(0), "A");
        s.answer("Done", s.activations("c").get(1), "B");

        assertThat(s.marking(m)).isEqualTo(Map.of("s", "generic", "y", "A", "x", "B"));
    }

    @Test
    void whoEntersWhenTheSharedInstanceIsOverIsReportedAndToldWhy() {
        Plan child = new NetBuilder("child")
                .start("c")
                .endShared("last")
                .input("stop", "Interrupt", Map.of("interruptName", new TextValue("Stop")), Map.of())
                .in("c", "stop", "always")
                .out("stop", "last", "take all proxy")
                .build();
        Plan parent = new NetBuilder("parent")
                .start("s")
                .shared("sub", "child")
                .transition("send", "News")
                .in("s", "send", "relevant all")
                .out("send", "sub", "take all relevant")
                .transition("back")
                .in("sub", "back", "always")
                .out("back", "x", "take all sub")
                .build();
        Session s = new Session(parent, child);
        long m = s.join("A", "B").start("parent");
        s.news("News", "A");
        s.press("Stop");
        assertThat(s.marking(m, "x")).isEqualTo("A");
        assertThat(s.notes()).isEmpty();

        s.news("News", "B");

        assertThat(s.notes()).containsExactly(NoteKind.NOT_RETURNED);
        assertThat(s.last().toString()).contains("'sub' was entered by B").contains("'child'");
        assertThat(s.view().whyNotEnabled(m, "back").reasons())
                .containsExactly("It waits for the sub-mission on 'sub', whose shared instance is over: "
                        + "nothing comes back from it any longer.");
    }

    @Test
    void aWriteGoesToTheNearestEnclosingPlanThatDeclaresIt() {
        Plan child = new NetBuilder("child")
                .start("c")
                .variable("@own", ValueType.Simple.INTEGER)
                .build();
        Session s = new Session(NetBuilder.project(
                List.of(new org.sami.spn.model.VariableSpec(
                        "@global", ValueType.Simple.INTEGER, java.util.Optional.empty())),
                parent().variable("@parents", ValueType.Simple.INTEGER)
                        .variable("@own", ValueType.Simple.INTEGER)
                        .build(),
                child));
        long m = s.join("A").start("parent");
        s.news("News", "A");
        long c = s.idOf("child");

        for (String name : List.of("@own", "@parents", "@global", "@nobodys")) {
            s.step(new Input.SetVariable(c, name, new IntegerValue(1)));
        }
        s.step(new Input.SetVariable(c, "@own", new TextValue("no number")));

        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        assertThat(s.view().variable(m, "@own")).isEmpty();
        assertThat(s.view().variable(c, "@own")).contains(new IntegerValue(1));
        assertThat(s.view().variable(m, "@parents")).contains(new IntegerValue(1));
        assertThat(s.view().variable(0, "@global")).contains(new IntegerValue(1));
        assertThat(s.view().variable(m, "@nobodys")).isEmpty();
    }

    @Test
    void aFieldThatHoldsAnotherTypeDoesNotWriteItsVariable() {
        Session s = new Session(new NetBuilder("plan")
                .variable("@number", ValueType.Simple.INTEGER)
                .start("s")
                .output(
                        "x",
                        "Do",
                        Map.of("number", new FieldSource.FromVariable("@undeclared")),
                        Map.of("number", "@number"))
                .transition("enter", "News")
                .in("s", "enter", "relevant all")
                .out("enter", "x", "add all relevant")
                .build());
        long m = s.join("A").start("plan");
        s.step(new Input.SetVariable(m, "@undeclared", new IntegerValue(1)));
        s.news("News", "A");
        assertThat(s.view().variable(m, "@number")).contains(new IntegerValue(1));

        s.step(new Input.SetVariable(m, "@undeclared", new TextValue("no number")));
        s.news("News", "A");

        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        assertThat(s.view().variable(m, "@number")).contains(new IntegerValue(1));
    }

    @Test
    void mappedVariablesAndTasksAreTheParents() {
        Plan child = new NetBuilder("child")
                .start("c")
                .output("c", "Do")
                .end("e")
                .task("Inner", "Measure", Map.of())
                .task("Own", "Measure", Map.of())
                .transition("over", "Done")
                .in("c", "over", "always")
                .out("over", "e", "take all task")
                .build();
        Session s = new Session(
                new NetBuilder("parent")
                        .start("s")
                        .variable("@outer", ValueType.Simple.INTEGER)
                        .task("Outer", "Measure", Map.of())
                        .sub("sub", "child", false, Map.of("Outer", "Inner"), Map.of("@inner", "@outer"))
                        .transition("send")
                        .in("s", "send", "always")
                        .out("send", "sub", "take all task")
                        .transition("back")
                        .in("sub", "back", "always")
                        .out("back", "x", "take all sub")
                        .build(),
                child);
        long m = s.start("parent");
        long c = s.idOf("child");
        assertThat(s.marking(c, "c")).isEqualTo("#Inner #Own");

        s.step(new Input.SetVariable(c, "@inner", new IntegerValue(4)));
        assertThat(s.view().variable(m, "@outer")).contains(new IntegerValue(4));
        assertThat(s.view().variable(c, "@inner")).contains(new IntegerValue(4));
        s.answer("Done", "c");

        assertThat(s.fired()).contains("back");
        assertThat(s.marking(m, "x")).isEqualTo("#Outer");
    }

    @Test
    void aDropReleasesTheRobotsTasksAlsoOfAnInstanceThatEndsWithIt() {
        Plan child = new NetBuilder("child")
                .task("T", "Measure", Map.of())
                .start("c")
                .output("c", "Do")
                .build();
        Session s = new Session(taking().build(), child);
        long m = s.join("A").start("parent");
        s.news("News", "A");
        TaskId task = new TaskId(s.idOf("child"), "T");
        s.step(new Input.AllocateTasks(Map.of(task, Optional.of("A"))));

        s.step(new Input.ProxyDropped("A", m));

        assertThat(s.view().missions()).as("the instance has ended").hasSize(1);
        assertThat(s.last())
                .contains(
                        new Effect.TasksAllocated(Map.of(task, Optional.empty()), Map.of(task, "A"), Priority.MEDIUM));
    }

    @Test
    void aDropFromAllMissionsIsLookedAtInTheOrderOfTheirIds() {
        Plan other = new NetBuilder("other")
                .start("o")
                .in("o", "few", "proxy == 1")
                .out("few", "rest", "take all any")
                .build();
        Plan child = new NetBuilder("child")
                .start("c")
                .in("c", "fewer", "proxy == 1")
                .out("fewer", "d", "take all any")
                .build();
        Session s = new Session(taking().build(), other, child);
        s.join("A", "B").start("parent");
        long second = s.start("other");
        s.news("News", "A", "B");
        long third = s.idOf("child");

        s.step(new Input.ProxyDropped("A", Ids.NONE));

        assertThat(s.last().stream().filter(Effect.Fired.class::isInstance).map(e -> ((Effect.Fired) e).mission()))
                .containsExactly(second, third);
    }
}
