package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.engine.SubMissionNets.CHILD;
import static org.sami.spn.engine.SubMissionNets.taking;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;

/** Interrupts (R-INT-*). */
class InterruptRulesTest {
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
    void aPressThatAsksForWhomIsWithdrawnByAnsweringNone() {
        Session s = new Session(proxyInterrupt());
        long m = s.join("A", "B").start("net");
        s.press("Pull");
        Decision asked = s.view().decisions().get(0);
        assertThat(asked.isInterruptChoice()).isTrue();

        s.decide(new Answer.Rejected());

        assertThat(s.last())
                .containsExactly(new Effect.DecisionClosed(
                        asked.id(), Optional.of(new Answer.Rejected()), Optional.of(Answerer.OPERATOR)));
        assertThat(s.view().decisions()).isEmpty();
        assertThat(s.view().interrupts()).containsExactly(new InterruptButton(m, "Pull", true));
        s.press("Pull", "A");
        assertThat(s.marking(m, "dock")).isEqualTo("A");
    }

    @Test
    void anInterruptPlaceAsksForTheRobotsUnlessThePressNamesThem() {
        Session s = new Session(proxyInterrupt());
        long m = s.join("A", "B", "C").start("net");
        assertThat(s.view().interrupts()).containsExactly(new InterruptButton(m, "Pull", true));

        s.press("Pull");
        s.decide(new Answer.Proxies(List.of("B")));
        s.press("Pull", "A");

        assertThat(s.marking(m, "dock")).isEqualTo("B A");
        assertThat(s.marking(m, "work")).isEqualTo("C");
    }

    private static Plan proxyInterrupt() {
        return new NetBuilder("net")
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
                .build();
    }
}
