package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Robots that a question or request names and that are gone (R-OCC-12), and filters that are left with none (R-DEC-10). */
class GoneRobotsTest {
    private static Map<String, Value> button(String name) {
        return Map.of("interruptName", new TextValue(name));
    }

    /** Robots and the generic token enter "w" together; "Pull" takes some of them to "away", "Open" puts a generic token into the gate. */
    private static NetBuilder asking(String question) {
        return new NetBuilder("net")
                .start("s")
                .output("w", question)
                .transition("in")
                .in("s", "in", "proxy >= 1")
                .out("in", "w", "take all any")
                .input("pull", "Interrupt", button("Pull"), Map.of())
                .in("w", "pull", "relevant >= 1")
                .out("pull", "away", "take all relevant")
                .input("open", "Interrupt", button("Open"), Map.of())
                .out("open", "gate", "add 1 generic");
    }

    private static Session started(NetBuilder net) {
        Session s = new Session(net.build());
        s.join("A", "B").start("net");
        return s;
    }

    private static void drop(Session s, String robot) {
        s.step(new Input.ProxyDropped(robot, Ids.NONE));
    }

    @ParameterizedTest
    @ValueSource(strings = {"dropped", "dropped from the mission", "pulled"})
    void anAnswerIsTakenWithoutWhoIsGoneWhicheverCameFirst(String how) {
        for (boolean goneFirst : new boolean[] {true, false}) {
            Session s = started(asking("ApproveThem")
                    .transition("yes", "YesThem")
                    .in("w", "yes", "relevant all")
                    .in("gate", "yes", "generic >= 1")
                    .out("yes", "d", "take all relevant"));
            Runnable leaves = () -> {
                switch (how) {
                    case "dropped" -> drop(s, "A");
                    case "pulled" -> s.press("Pull", "A");
                    default -> s.step(new Input.ProxyDropped("A", s.idOf("net")));
                }
            };

            if (goneFirst) {
                leaves.run();
                s.decide(new Answer.YesNo(true));
                assertThat(s.notes()).containsExactly(NoteKind.GONE);
            } else {
                s.decide(new Answer.YesNo(true));
                leaves.run();
            }
            s.press("Open");

            assertThat(s.marking(s.idOf("net"), "d"))
                    .as("gone first: %s", goneFirst)
                    .isEqualTo("B");
        }
    }

    @Test
    void aServicesAnswerIsTakenWithoutWhoMovedOn() {
        Session s = started(asking("Do")
                .transition("each", "Done2")
                .in("w", "each", "relevant all")
                .out("each", "away", "take all relevant")
                .transition("both", "Done")
                .in("w", "both", "relevant all")
                .out("both", "d", "take all relevant"));
        s.answer("Done2", "w", "A");

        s.answer("Done", "w", "A", "B");

        assertThat(s.marking(s.idOf("net"))).isEqualTo(Map.of("w", "generic", "away", "A", "d", "B"));
        assertThat(s.notes()).containsExactly(NoteKind.GONE);
    }

    @Test
    void whoMovedToAnotherPlaceOfTheTransitionIsNotGone() {
        Session s = started(asking("Do")
                .transition("both", "Done")
                .in("w", "both", "always")
                .in("away", "both", "relevant >= 1")
                .out("both", "d", "take all relevant"));
        s.press("Pull", "A");

        s.answer("Done", "w", "A", "B");

        assertThat(s.marking(s.idOf("net"))).isEqualTo(Map.of("w", "generic", "d", "B A"));
        assertThat(s.notes()).isEmpty();
    }

    @Test
    void whomTheQuestionDidNotNameIsWaitedFor() {
        Session s = started(asking("Do")
                .transition("both", "Done")
                .in("w", "both", "always")
                .in("away", "both", "relevant all")
                .out("both", "d", "take all relevant"));
        s.join("C");
        s.answer("Done", "w", "A", "C");
        assertThat(s.notes()).isEmpty();

        s.press("Pull", "A");

        assertThat(s.allFired()).doesNotContain("both");
    }

    @Test
    void whereNobodyIsLeftTheAnswerNamesNobody() {
        Session s = started(asking("ApproveThem")
                .transition("yes", "YesThem")
                .in("w", "yes", "relevant all")
                .out("yes", "d", "take all relevant")
                .transition("no", "NoThem")
                .in("w", "no", "generic >= 1")
                .out("no", "e", "take all any"));
        s.press("Pull", "A", "B");

        s.decide(new Answer.YesNo(true));
        assertThat(s.notes()).as("yes asks for somebody").containsExactly(NoteKind.NAMES_NOBODY);
        assertThat(s.onlyDecision().question()).isEqualTo(new Question.Approve());
        s.decide(new Answer.YesNo(false));

        assertThat(s.marking(s.idOf("net"))).isEqualTo(Map.of("away", "A B", "e", "generic"));
    }

    @Test
    void aServicesAnswerThatNamesOnlyWhoIsGoneLeavesTheRequestOpen() {
        Session s = started(asking("Do")
                .transition("done", "Done")
                .in("w", "done", "relevant all")
                .out("done", "d", "take all relevant"));
        s.press("Pull", "A");

        s.answer("Done", "w", "A");
        assertThat(s.notes()).containsExactly(NoteKind.DISCARDED);
        s.answer("Done", "w", "B");

        assertThat(s.marking(s.idOf("net"))).isEqualTo(Map.of("w", "generic", "away", "A", "d", "B"));
    }

    @Test
    void aChoiceOfWhoIsGoneKeepsTheQuestionOpen() {
        Session s = started(asking("Choose")
                .transition("chosen", "Chosen")
                .in("w", "chosen", "relevant all")
                .out("chosen", "d", "take all relevant"));
        s.press("Pull", "A");

        s.decide(new Answer.Proxies(List.of("A")));
        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        s.decide(new Answer.Proxies(List.of("A", "B")));

        assertThat(s.marking(s.idOf("net"), "d")).isEqualTo("B");
    }

    @Test
    void aChoiceOfWhoIsGoneIsAChoiceOfNobodyWhateverTheTransitionAsksFor() {
        Session s = started(asking("Choose")
                .transition("any", "Chosen")
                .in("w", "any", "proxy >= 1")
                .out("any", "d", "take all proxy"));
        s.press("Pull", "A");

        s.decide(new Answer.Proxies(List.of("A")));

        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        assertThat(s.fired()).isEmpty();
    }

    @Test
    void anAnswerOfWhoIsGoneIsForTransitionsThatAskForNobody() {
        Session s = started(asking("Do")
                .transition("any", "Done")
                .in("w", "any", "proxy >= 1")
                .out("any", "d", "take all proxy"));
        drop(s, "A");

        s.answer("Done", "w", "A");

        assertThat(s.marking(s.idOf("net"))).isEqualTo(Map.of("w", "generic", "d", "B"));
        assertThat(s.notes()).containsExactly(NoteKind.GONE);
    }

    /** Nobody entered: the question offers those who stand in its place. */
    private static Session offeringThoseWhoStand() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("w", "Choose")
                .transition("in")
                .in("s", "in", "proxy >= 1")
                .out("in", "w", "take all proxy")
                .transition("ask", "News")
                .in("s", "ask", "generic >= 1")
                .out("ask", "w", "always")
                .input("pull", "Interrupt", button("Pull"), Map.of())
                .in("w", "pull", "relevant >= 1")
                .out("pull", "away", "take all relevant")
                .transition("chosen", "Chosen")
                .in("w", "chosen", "relevant all")
                .in("gate", "chosen", "generic >= 1")
                .out("chosen", "d", "take all relevant")
                .input("open", "Interrupt", button("Open"), Map.of())
                .out("open", "gate", "add 1 generic")
                .build());
        s.join("A", "B").start("net");
        s.decide(new Answer.Proxies(List.of("A"))); // the first question, of those who entered, waits at the gate
        s.press("Pull", "A");
        s.news("News");
        return s;
    }

    @Test
    void whoIsOfferedBecauseItStoodThereAndIsGoneIsStruckToo() {
        Session s = offeringThoseWhoStand();
        s.join("C");
        assertThat(s.onlyDecision().question())
                .isEqualTo(new Question.ChooseProxies(List.of("B"), 1, Integer.MAX_VALUE));
        s.press("Pull", "B");

        s.decide(new Answer.Proxies(List.of("B")));

        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        assertThat(s.onlyDecision().question()).isInstanceOf(Question.ChooseProxies.class);
    }

    @Test
    void whoIsOfferedBecauseItStoodThereAndLeavesAfterTheAnswerIsStruckToo() {
        Session s = offeringThoseWhoStand();
        s.decide(new Answer.Proxies(List.of("B")));

        s.press("Pull", "B");

        assertThat(s.notes()).containsExactly(NoteKind.DISCARDED);
    }

    private static MarkupSpec filter(String text) {
        return new MarkupSpec(
                "Filter", Map.of("source", new TextValue(text), "action", new EnumValue("FilterAction", "INCLUDE")));
    }

    private static Session filtered(String question) {
        NetBuilder net = new NetBuilder("net")
                .start("s")
                .output("s", question, filter("A"))
                .transition("chosen", "Chosen")
                .in("s", "chosen", "relevant all")
                .out("chosen", "d", "take all relevant")
                .input("pull", "Interrupt", button("Pull"), Map.of())
                .in("s", "pull", "relevant >= 1")
                .out("pull", "away", "take all relevant");
        Session s = new Session(net.build());
        s.join("A", "B", "C").start("net");
        return s;
    }

    private static List<String> offered(Session s) {
        return ((Question.ChooseProxies) s.onlyDecision().question()).proxies();
    }

    @Test
    void aFilterWhoseLastRobotIsDroppedOffersAllWhoAreStillThere() {
        Session s = filtered("Choose");
        assertThat(offered(s)).containsExactly("A");
        drop(s, "B");
        assertThat(offered(s)).containsExactly("A");

        drop(s, "A");

        assertThat(offered(s)).containsExactly("C");
        assertThat(s.notes()).containsExactly(NoteKind.GONE);
    }

    @Test
    void aFilterWhoseLastRobotIsPulledOffersAllWhoAreStillThere() {
        Session s = filtered("ChooseSome");

        s.press("Pull", "A", "C");

        assertThat(offered(s)).containsExactly("B");
        assertThat(s.notes()).containsExactly(NoteKind.GONE);
        s.decide(new Answer.Proxies(List.of("B")));
        assertThat(s.marking(s.idOf("net"), "d")).isEqualTo("B");
    }

    @Test
    void aChoiceWithoutFilterIsNotAskedAnewWhenARobotMovesOn() {
        Session s = started(asking("Choose"));
        long asked = s.onlyDecision().id();

        s.press("Pull", "A");

        assertThat(s.onlyDecision().id()).isEqualTo(asked);
    }

    @Test
    void whoIsGoneIsTheSameAfterASnapshot() {
        Session s = offeringThoseWhoStand();
        s.press("Pull", "B");
        Activation asked = s.latest("w");
        s.replaceState(StateCodec.decode(StateCodec.encode(s.state()), s.engine()));

        s.decide(new Answer.Proxies(List.of("B")));

        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        assertThat(asked.tokens()).isEmpty();
    }
}
