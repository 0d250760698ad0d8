package org.sami.crw.gui.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.decision.Asker;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.EnumValue;

class DecisionWordsTest {
    private static PendingDecision pending(Optional<Answer> automatic, OptionalLong deadline, Priority priority) {
        List<MarkupSpec> timer =
                List.of(new MarkupSpec("MixedInitiativeTrigger", Map.of("trigger", new EnumValue("Trigger", "TIMER"))));
        Question question = new Question.ChooseProxies(List.of("anna", "bert"), 1, 2);
        return new PendingDecision(
                new Decision(1, 1, 1, "Select", "Which boats?", question, automatic, deadline, priority, timer), 1000);
    }

    @ParameterizedTest
    @CsvSource({"0,0 s", "-5,0 s", "59999,59 s", "60000,1 min 00 s", "3599000,59 min 59 s", "7320000,2 h 02 min"})
    void timesAreWrittenInTwoUnitsAtMost(long millis, String text) {
        assertThat(DecisionWords.span(millis)).isEqualTo(text);
    }

    @Test
    void ageSaysHowUrgentItIs() {
        assertThat(DecisionWords.age(pending(Optional.empty(), OptionalLong.empty(), Priority.MEDIUM), 13_000))
                .isEqualTo("asked 12 s ago");
        assertThat(DecisionWords.age(pending(Optional.empty(), OptionalLong.empty(), Priority.CRITICAL), 13_000))
                .isEqualTo("▲ critical · asked 12 s ago");
    }

    @Test
    void autonomySaysWhatItAnswersAndWhen() {
        Optional<Answer> all = Optional.of(new Answer.Proxies(List.of("anna", "bert")));
        PendingDecision running = pending(all, OptionalLong.of(20_000), Priority.MEDIUM);

        assertThat(DecisionWords.autonomy(running, 8_000)).isEqualTo("Autonomy chooses anna, bert in 12 s");
        assertThat(DecisionWords.autonomy(running, 19_999)).endsWith(" in 1 s");
        assertThat(DecisionWords.autonomy(pending(all, OptionalLong.empty(), Priority.MEDIUM), 8_000))
                .isEqualTo("The timer was stopped: only you answer");
    }

    @Test
    void autonomyNamesFewBoatsAndCountsMany() {
        Optional<Answer> five = Optional.of(new Answer.Proxies(List.of("a", "b", "c", "d", "e")));

        assertThat(DecisionWords.autonomy(pending(five, OptionalLong.of(41_000), Priority.MEDIUM), 1_000))
                .isEqualTo("Autonomy chooses 5 boats in 40 s");
        assertThat(DecisionWords.autonomy(
                        pending(Optional.of(new Answer.YesNo(true)), OptionalLong.of(41_000), Priority.MEDIUM), 1_000))
                .isEqualTo("Autonomy answers yes in 40 s");
        assertThat(DecisionWords.autonomy(pending(Optional.empty(), OptionalLong.of(41_000), Priority.MEDIUM), 1_000))
                .isEqualTo("Autonomy gives no answer in 40 s");
    }

    @Test
    void aLineOfTheQueueSaysWhoAsksSinceWhenAndHowLongThereIs() {
        Optional<Answer> all = Optional.of(new Answer.Proxies(List.of("anna", "bert")));
        PendingDecision plain = pending(all, OptionalLong.of(200_000), Priority.HIGH);
        Asker bay = new Asker("explore", "Explore Area", "the bay", "choose", "Choose boats", "Select Boats");

        assertThat(WaitingRow.of(plain, 14_000))
                .isEqualTo(new WaitingRow(1, Priority.HIGH, "△ Which boats?", "the system", "13 s", "3 min"));
        assertThat(DecisionWords.mission(asked(1, bay))).isEqualTo("the bay · Explore Area");
        assertThat(DecisionWords.mission(
                        asked(1, new Asker("explore", "Explore Area", "explore", "choose", "Choose boats", ""))))
                .isEqualTo("Explore Area");
        assertThat(DecisionWords.left(pending(all, OptionalLong.empty(), Priority.MEDIUM), 0))
                .isEqualTo("stopped");
    }

    @Test
    void whatTheSystemAsksAboutAMissionBeginsWithTheMissionsName() {
        Asker beach = new Asker("explore", "Explore Area", "the beach", "go", "Explore", "Proxy Explore Area");

        assertThat(DecisionWords.heading(asked(Ids.NONE, beach)))
                .isEqualTo("the beach: charges are sure to last for 48 % of the area. Send them?");
        assertThat(DecisionWords.heading(asked(Ids.NONE, Asker.UNKNOWN)))
                .isEqualTo("charges are sure to last for 48 % of the area. Send them?");
        assertThat(DecisionWords.heading(asked(1, beach)))
                .isEqualTo("charges are sure to last for 48 % of the area. Send them?");
    }

    private static DecisionPresentation asked(long mission, Asker asker) {
        Decision decision = new Decision(
                1,
                mission,
                Ids.NONE,
                "LongWay",
                "charges are sure to last for 48 % of the area. Send them?",
                new Question.Approve(),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.HIGH,
                List.of());
        DecisionPresentation plain = DecisionPresenter.plain(decision);
        return new DecisionPresentation(
                decision,
                asker,
                plain.boats(),
                plain.description(),
                plain.options(),
                plain.format(),
                plain.autonomy(),
                plain.attention(),
                plain.proposedLocation(),
                plain.map(),
                plain.approved());
    }
}
