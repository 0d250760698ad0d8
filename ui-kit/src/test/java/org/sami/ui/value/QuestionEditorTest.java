package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.component.Interaction;
import org.sami.spn.component.Purpose;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

class QuestionEditorTest {
    private static final Value AUCTION = SampleDomain.allocation("sequential auction", 812.4);
    private static final Value NEAREST = SampleDomain.allocation("nearest first", 954.1);

    @Test
    void onlyOptionIsSeenBeforeItIsChosenAndChosenByPressingIt() {
        QuestionEditor editor = asking(AUCTION);

        assertThat(editor.values()).containsExactly(AUCTION);
        assertThat(editor.answer()).isEmpty();
        assertThat(editor.reason()).contains("Choose option 1");

        editor.choose(0);
        assertThat(editor.answer()).isPresent();
    }

    @Test
    void ofSeveralOptionsTheChosenOneIsSeen() {
        QuestionEditor editor = asking(AUCTION, NEAREST);
        assertThat(editor.values()).isEmpty();

        editor.choose(1);
        assertThat(editor.values()).containsExactly(NEAREST);
    }

    private static QuestionEditor asking(Value... options) {
        List<OfferedRow> rows = new ArrayList<>();
        for (Value option : options) {
            rows.add(new OfferedRow(rows.size(), new ChoiceRow(option, String.valueOf(rows.size() + 1), ""), false));
        }
        ValueType type = TypeNames.parse("list<Allocation>").orElseThrow();
        return new QuestionEditor(
                "allocation",
                new Question.ChooseOption(List.of(options)),
                rows,
                SampleDomain.CHOICE.choose(new Interaction(Purpose.SELECT, Map.of("answer", type), List.of())),
                SampleDomain.EDITORS);
    }
}
