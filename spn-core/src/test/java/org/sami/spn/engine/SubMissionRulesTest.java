package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.engine.SubMissionNets.CHILD;
import static org.sami.spn.engine.SubMissionNets.parent;
import static org.sami.spn.engine.SubMissionNets.taking;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;

/** Visits and shared instances of sub-missions (R-SUB-*). */
class SubMissionRulesTest {
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
