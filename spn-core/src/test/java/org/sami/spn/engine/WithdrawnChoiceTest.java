package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.TextValue;

/** Whom choices of sub-missions offer when an interrupt outside takes robots out of them (R-DEC-8, R-INT-7). */
class WithdrawnChoiceTest {
    private static final List<String> NOBODY = List.of();

    private static Plan choosing(MarkupSpec... markups) {
        return new NetBuilder("child")
                .start("c")
                .output("c", "Choose", markups)
                .end("e")
                .transition("go", "Chosen")
                .in("c", "go", "relevant all")
                .out("go", "chosen", "take all relevant")
                .build();
    }

    /** A plan that runs another on a place that all robots enter at once, with a generic token. */
    private static NetBuilder around(String id, String inner, boolean shared) {
        NetBuilder net = new NetBuilder(id)
                .start(id + "-start")
                .transition(id + "-in")
                .in(id + "-start", id + "-in", "proxy >= 1")
                .out(id + "-in", id + "-sub", "take all proxy", "take all generic");
        return shared ? net.shared(id + "-sub", inner) : net.sub(id + "-sub", inner);
    }

    private static Plan pulling(String inner, boolean shared, String to) {
        return around("root", inner, shared)
                .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Pull")), Map.of())
                .in("root-sub", "pull", "relevant >= 1")
                .out("pull", to, "take all relevant")
                .build();
    }

    private static List<String> offered(Session s) {
        return ((Question.ChooseProxies) s.onlyDecision().question()).proxies();
    }

    private static long decisionsOpened(Session s) {
        return s.last().stream().filter(Effect.DecisionOpened.class::isInstance).count();
    }

    @Test
    void choiceIsAskedAnewOnceWithoutTheRobotsThatWereTakenOut() {
        for (boolean shared : new boolean[] {false, true}) {
            Session s = new Session(pulling("child", shared, "away"), choosing());
            s.join("A", "B", "C").start("root");
            Decision before = s.onlyDecision();

            List<Effect> told = s.press("Pull", "A", "C");

            assertThat(told)
                    .contains(
                            new Effect.DecisionClosed(before.id(), Optional.empty(), Optional.empty()),
                            new Effect.DecisionOpened(s.onlyDecision()));
            assertThat(decisionsOpened(s)).isEqualTo(1);
            assertThat(offered(s)).containsExactly("B");
            assertThat(s.onlyDecision().automatic()).contains(new Answer.Proxies(List.of("B")));
            s.step(new Input.AnswerDecision(before.id(), new Answer.Proxies(List.of("A")), Answerer.OPERATOR));
            assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
            s.decide(new Answer.Proxies(List.of("B")));
            assertThat(s.fired()).containsExactly("go");
        }
    }

    @Test
    void choiceOfAnInstanceWithinAnInstanceIsAskedAnewAndKeepsItsDeadline() {
        Plan middle = around("middle", "child", false).build();
        Session s =
                new Session(pulling("middle", false, "away"), middle, choosing(MixedInitiative.trigger("TIMER", 2000)));
        s.join("A", "B").start("root");
        s.advance(500);

        s.press("Pull", "A");

        assertThat(offered(s)).containsExactly("B");
        assertThat(s.onlyDecision().deadlineMillis()).hasValue(2000);
        s.advance(1500);
        assertThat(s.fired()).containsExactly("go");
    }

    @Test
    void choiceOfWhichNobodyIsLeftSaysSo() {
        Session s = new Session(pulling("child", false, "away"), choosing());
        s.join("A").start("root");

        List<Effect> told = s.press("Pull", "A");

        assertThat(offered(s)).isEqualTo(NOBODY);
        assertThat(told)
                .contains(new Effect.Noted(
                        NoteKind.NAMES_NOBODY,
                        s.idOf("child"),
                        "Nobody is left to choose for 'Choose (c)': 'A' was withdrawn"));
    }

    @Test
    void robotThatComesBackInTheSameFiringIsOfferedByTheNewChoiceOnly() {
        Session s = new Session(pulling("child", true, "root-sub"), choosing());
        s.join("A", "B").start("root");

        s.press("Pull", "A");

        List<List<String>> offers = new ArrayList<>();
        s.view().decisions().forEach(open -> offers.add(((Question.ChooseProxies) open.question()).proxies()));
        assertThat(offers).containsExactly(List.of("B"), List.of("A"));
    }

    @Test
    void choiceForAnInterruptOfTheSubMissionIsGivenUpWhenNobodyIsLeft() {
        Plan child = new NetBuilder("child")
                .start("c")
                .output(
                        "button",
                        "ProxyInterrupt",
                        Map.of("interruptName", new FieldSource.Fixed(new TextValue("Swap"))),
                        Map.of())
                .transition("begin")
                .in("c", "begin", "always")
                .out("begin", "work", "take all proxy")
                .out("begin", "button", "take 1 generic")
                .transition("swap", "ProxyInterruptReceived")
                .in("button", "swap", "generic >= 1")
                .in("work", "swap", "relevant >= 1")
                .out("swap", "dock", "take all relevant")
                .build();
        Session s = new Session(pulling("child", false, "away"), child);
        s.join("A").start("root");
        s.press("Swap");
        assertThat(offered(s)).containsExactly("A");

        s.press("Pull", "A");

        assertThat(s.view().decisions()).isEmpty();
        assertThat(s.notes()).containsExactly(NoteKind.INTERRUPT_REFUSED);
    }
}
