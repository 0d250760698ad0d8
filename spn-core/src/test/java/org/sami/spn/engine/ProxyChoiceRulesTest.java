package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;

/** Which robots a choice offers, and what becomes of it when one is dropped (R-DEC-4, R-DEC-5, R-DEC-10, R-DEC-11). */
class ProxyChoiceRulesTest {
    @Test
    void choicesAreCheckedAndNamingNobodyKeepsTheQuestionOpen() {
        Session s = new Session(new NetBuilder("net")
                .start("s")
                .output("s", "ChooseSome")
                .transition("t", "Chosen")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
        s.join("A", "B").start("net");

        s.decide(new Answer.Proxies(List.of("C")));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.decide(new Answer.Proxies(List.of("A", "A")));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.decide(new Answer.Proxies(List.of()));
        assertThat(s.notes()).containsExactly(NoteKind.NAMES_NOBODY);
        s.decide(new Answer.Proxies(List.of("B")));

        assertThat(s.fired()).containsExactly("t");
    }

    private static Session choice(MarkupSpec... markups) {
        return new Session(new NetBuilder("net")
                .start("s")
                .output("s", "Choose", markups)
                .transition("t", "Chosen")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build());
    }

    private static Input drop(String robot) {
        return new Input.ProxyDropped(robot, Ids.NONE);
    }

    @Test
    void choiceIsAskedAnewWithoutARobotThatIsDropped() {
        Session s = choice();
        s.join("A", "B").start("net");
        Decision before = s.onlyDecision();

        List<Effect> told = s.step(drop("A"));

        Decision after = s.onlyDecision();
        assertThat(told)
                .contains(
                        new Effect.DecisionClosed(before.id(), Optional.empty(), Optional.empty()),
                        new Effect.DecisionOpened(after));
        assertThat(after.question()).isEqualTo(new Question.ChooseProxies(List.of("B"), 1, Integer.MAX_VALUE));
        assertThat(after.automatic()).contains(new Answer.Proxies(List.of("B")));
        s.step(new Input.AnswerDecision(before.id(), new Answer.Proxies(List.of("A")), Answerer.OPERATOR));
        assertThat(s.notes()).containsExactly(NoteKind.REJECTED_INPUT);
        s.decide(new Answer.Proxies(List.of("B")));
        assertThat(s.fired()).containsExactly("t");
    }

    @Test
    void choiceThatIsAskedAnewKeepsItsDeadline() {
        Session s = choice(MixedInitiative.trigger("TIMER", 2000));
        s.join("A", "B").start("net");
        s.advance(500);

        s.step(drop("A"));

        assertThat(s.onlyDecision().deadlineMillis()).hasValue(2000);
        s.advance(1500);
        assertThat(s.fired()).containsExactly("t");
    }

    @Test
    void choiceThatIsAskedAnewTwiceKeepsTheDeadlineThatItHadAtFirst() {
        Session s = choice(MixedInitiative.trigger("TIMER", 2000));
        s.join("A", "B", "C").start("net");
        s.advance(500);
        s.step(drop("A"));
        s.advance(500);

        s.step(drop("B"));

        assertThat(s.onlyDecision().deadlineMillis()).hasValue(2000);
        assertThat(s.view().nextDueMillis()).hasValue(2000);
        s.advance(999);
        assertThat(s.fired()).isEmpty();
        s.advance(1);
        assertThat(s.fired()).containsExactly("t");
    }

    @Test
    void deadlineThatPassedWithoutAnAnswerIsNotSetAgain() {
        MarkupSpec nobody =
                new MarkupSpec("DefaultSelection", Map.of("selection", new EnumValue("SelectionDefault", "NONE")));
        Session s = choice(MixedInitiative.trigger("TIMER", 2000), nobody);
        s.join("A", "B").start("net");
        s.advance(2000);
        assertThat(s.notes()).containsExactly(NoteKind.NO_AUTOMATIC_ANSWER);

        s.step(drop("A"));

        assertThat(s.onlyDecision().deadlineMillis()).isEmpty();
        assertThat(s.view().nextDueMillis()).isEmpty();
    }

    @Test
    void choiceOfWhichNobodyIsLeftSaysSo() {
        Session s = choice();
        s.join("A").start("net");

        List<Effect> told = s.step(drop("A"));

        assertThat(told)
                .contains(new Effect.Noted(
                        NoteKind.NAMES_NOBODY, 1, "Nobody is left to choose for 'Choose (s)': 'A' was dropped"));
        assertThat(s.onlyDecision().question()).isEqualTo(new Question.ChooseProxies(List.of(), 1, Integer.MAX_VALUE));
    }

    @Test
    void choiceForAnInterruptIsGivenUpWhenNobodyIsLeft() {
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
        s.join("A").start("net");
        s.press("Pull");
        assertThat(s.view().decisions()).hasSize(1);

        s.step(drop("A"));

        assertThat(s.view().decisions()).isEmpty();
        assertThat(s.notes()).containsExactly(NoteKind.INTERRUPT_REFUSED);
    }

    @ParameterizedTest
    @CsvSource({
        "INCLUDE, shore,   boat-1",
        "INCLUDE, WATER,   boat-2",
        "EXCLUDE, SHORE,   boat-2 spare",
        "INCLUDE, spare,   spare",
        "INCLUDE, boat,    boat-1 boat-2",
        "INCLUDE, nothing, boat-1 boat-2 spare", // nobody could answer
    })
    void aFilterOffersRobotsByNameAndByWhatTheyAreCalled(String action, String source, String offered) {
        Session s = new Session(chooseSome(filter(action, source), MixedInitiative.trigger("TIMER", 10)));
        s.join("boat-1", "boat-2", "spare");
        s.step(new Input.Remember(Ids.NONE, "description/boat-1", new TextValue("SHORE")));
        s.step(new Input.Remember(Ids.NONE, "description/boat-2", new TextValue("Water, deployed")));
        s.start("net");
        List<String> boats = List.of(offered.split(" "));

        assertThat(((Question.ChooseProxies) s.onlyDecision().question()).proxies())
                .isEqualTo(boats);
        s.advance(10);

        assertThat(s.last())
                .contains(new Effect.DecisionClosed(
                        1, Optional.of(new Answer.Proxies(boats)), Optional.of(Answerer.AUTONOMY)));
    }

    @Test
    void everyFilterCounts() {
        Session s = new Session(chooseSome(filter("INCLUDE", "boat"), filter("EXCLUDE", "1")));
        s.join("boat-1", "boat-2", "spare").start("net");

        assertThat(((Question.ChooseProxies) s.onlyDecision().question()).proxies())
                .containsExactly("boat-2");
    }

    @Test
    void autonomyChoosesNobodyWhereNobodyIsSelected() {
        MarkupSpec nobody =
                new MarkupSpec("DefaultSelection", Map.of("selection", new EnumValue("SelectionDefault", "NONE")));
        Session s = new Session(chooseSome(nobody, MixedInitiative.trigger("TIMER", 10)));
        s.join("A", "B").start("net");

        s.advance(10);

        assertThat(s.notes()).containsExactly(NoteKind.NO_AUTOMATIC_ANSWER);
        assertThat(s.view().decisions()).hasSize(1);
    }

    private static Plan chooseSome(MarkupSpec... markups) {
        return new NetBuilder("net")
                .start("s")
                .output("s", "ChooseSome", markups)
                .transition("t", "Chosen")
                .in("s", "t", "relevant all")
                .out("t", "x", "take all relevant")
                .build();
    }

    private static MarkupSpec filter(String action, String source) {
        return new MarkupSpec(
                "Filter", Map.of("source", new TextValue(source), "action", new EnumValue("FilterAction", action)));
    }
}
