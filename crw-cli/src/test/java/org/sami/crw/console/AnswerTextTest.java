package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.DecisionPresenter;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

class AnswerTextTest {
    private static final Question APPROVE = new Question.Approve();
    private static final Question BOATS = new Question.ChooseProxies(List.of("anna", "bo", "cleo"), 1, 2);
    private static final Question OPTIONS =
            new Question.ChooseOption(List.of(new TextValue("near"), new TextValue("far")));
    private static final Question FORM = new Question.FillIn(List.of(
            item("speed", ValueType.Simple.REAL, Optional.empty(), true),
            item("times", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(3)), true),
            item("fixed", ValueType.Simple.TEXT, Optional.of(new TextValue("x")), false)));
    private static final Question ONE =
            new Question.FillIn(List.of(item("question", ValueType.Simple.TEXT, Optional.empty(), true)));

    private final AnswerText answers = new AnswerText(Map.of());

    private static Question.Item item(String key, ValueType type, Optional<Value> preset, boolean editable) {
        return new Question.Item(key, type, "", preset, editable, "");
    }

    private Answer read(Question question, String line) {
        return answers.read(shown(question), CommandLineText.words(line));
    }

    private static DecisionPresentation shown(Question question, MarkupSpec... markups) {
        return DecisionPresenter.plain(new Decision(
                1,
                1,
                1,
                "Ask",
                "Which?",
                question,
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of(markups)));
    }

    @Test
    void optionsHaveTheNumbersWithWhichTheyAreShown() {
        MarkupSpec sort = new MarkupSpec("Sort", Map.of("method", new EnumValue("SortMethod", "ALPHABETICAL")));
        DecisionPresentation asked =
                shown(new Question.ChooseOption(List.of(new TextValue("west"), new TextValue("east"))), sort);

        assertThat(answers.form(asked)).startsWith("1  east", "2  west");
        assertThat(answers.read(asked, List.of("1"))).isEqualTo(new Answer.Option(1));
    }

    @Test
    void wordsBecomeTheAnswerThatIsAskedFor() {
        assertThat(read(APPROVE, "yes")).isEqualTo(new Answer.YesNo(true));
        assertThat(read(APPROVE, "n")).isEqualTo(new Answer.YesNo(false));
        assertThat(read(BOATS, "anna, cleo")).isEqualTo(new Answer.Proxies(List.of("anna", "cleo")));
        assertThat(read(BOATS, "all")).isEqualTo(new Answer.Proxies(List.of("anna", "bo", "cleo")));
        assertThat(read(OPTIONS, "2")).isEqualTo(new Answer.Option(1));
        assertThat(read(OPTIONS, "none")).isEqualTo(new Answer.Rejected());
    }

    @Test
    void fieldsTakeTheirDefaultsAndOnlyEditableOnesAreAnswered() {
        assertThat(read(FORM, "speed=1.5"))
                .isEqualTo(new Answer.Fields(Map.of("speed", new RealValue(1.5), "times", new IntegerValue(3))));
        assertThat(read(ONE, "'a = b'")).isEqualTo(new Answer.Fields(Map.of("question", new TextValue("a = b"))));
        assertThat(read(ONE, "question=\"two words\""))
                .isEqualTo(new Answer.Fields(Map.of("question", new TextValue("two words"))));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        approve | maybe      | 'maybe' is no answer here; expected is yes or no
        approve | ''         | an answer is missing; expected is yes or no
        options | 0          | '0' is no answer here
        options | 3          | the number of an option, or none
        form    | pace=1     | 'pace=1' is no answer here
        form    | fixed=y    | 'fixed=y' is no answer here
        form    | speed=fast | speed cannot be 'fast': expected is a number such as 2.5
        """)
    void whatIsNoAnswerIsNamedWithWhatIsExpected(String which, String line, String message) {
        Question question = switch (which) {
            case "approve" -> APPROVE;
            case "options" -> OPTIONS;
            default -> FORM;
        };

        assertThatThrownBy(() -> read(question, line))
                .isInstanceOf(ConsoleFault.class)
                .hasMessageContaining(message);
    }

    @Test
    void workWithoutValuesIsAnsweredByItsNumberAlone() {
        Question swap = new Question.FillIn(
                List.of(item("question", ValueType.Simple.TEXT, Optional.of(new TextValue("Swap them")), false)));

        assertThat(answers.form(shown(swap))).containsExactly("its number alone: it is done");
        assertThat(read(swap, "")).isEqualTo(new Answer.Fields(Map.of()));
        assertThatThrownBy(() -> read(swap, "yes")).hasMessageContaining("its number alone");
    }

    @Test
    void formSaysHowToAnswer() {
        assertThat(answers.form(shown(BOATS))).containsExactly("1 to 2 of anna, bo, cleo, or all");
        assertThat(answers.form(shown(new Question.ChooseProxies(List.of(), 1, 2))))
                .containsExactly("nobody is there to choose");
        assertThat(answers.form(shown(OPTIONS)).get(1)).startsWith("2  ").contains("far");
        assertThat(answers.form(shown(FORM)))
                .containsExactly(
                        "speed=VALUE  (real: a number such as 2.5)", "times=VALUE  (integer: a whole number, else 3)");
        assertThat(answers.completions(shown(FORM))).containsExactly("speed=", "times=");
    }

    @Test
    void lineIsSplitAtSpacesOutsideQuotesUpToARemark() {
        assertThat(CommandLineText.words("  start clv 'a b'\"c\" x#y # remark"))
                .containsExactly("start", "clv", "a bc", "x#y");
        assertThat(CommandLineText.words("''")).containsExactly("");
        assertThatThrownBy(() -> CommandLineText.words("say 'hello")).hasMessageContaining("not closed");
    }
}
