package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.sami.spn.component.Interaction;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.Purpose;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.ui.map.MapView;

class QuestionEditorTest {
    private static final Value AUCTION = SampleDomain.allocation("sequential auction", 812.4);
    private static final Value NEAREST = SampleDomain.allocation("nearest first", 954.1);

    private static final MarkupOption WITH_MAPS = new MarkupOption("RelevantProxy", "showPath", "true");

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
    void ofSeveralOptionsTheOneThatIsLookedAtIsSeenAndChoosesNothing() {
        QuestionEditor editor = asking(AUCTION, NEAREST);
        AtomicInteger told = new AtomicInteger();
        editor.onLooked(told::incrementAndGet);
        assertThat(editor.values()).containsExactly(AUCTION);

        editor.look(1);
        assertThat(editor.values()).containsExactly(NEAREST);
        assertThat(editor.looked()).hasValue(1);
        assertThat(told).hasValue(1);
        assertThat(editor.answer()).isEmpty();
        assertThat(editor.isTouched()).isFalse();

        editor.look(1);
        assertThat(editor.values()).as("after the last comes the first").containsExactly(AUCTION);

        editor.choose(1);
        assertThat(editor.values()).containsExactly(NEAREST);
        assertThat(editor.answer()).contains(new Answer.Option(1));
    }

    @Test
    void onlyOptionHasNoMapOfItsOwnWhereALargeOneShowsIt() {
        QuestionEditor editor = asking(AUCTION);
        assertThat(previews(editor)).singleElement().matches(Component::isVisible);

        editor.useOwnMaps(false);
        assertThat(previews(editor)).noneMatch(Component::isVisible);

        editor.useOwnMaps(true);
        assertThat(previews(editor)).allMatch(Component::isVisible);
    }

    @Test
    void severalOptionsHaveMapsOfTheirOwnOnlyWhereNoLargeOneShowsThem() {
        QuestionEditor editor = asking(AUCTION, NEAREST);
        assertThat(previews(editor)).hasSize(2).allMatch(Component::isVisible);

        editor.useOwnMaps(false);

        assertThat(previews(editor)).noneMatch(Component::isVisible);
    }

    private static List<MapView> previews(QuestionEditor editor) {
        List<MapView> found = new ArrayList<>();
        collect(editor.component(), found);
        return found;
    }

    private static void collect(Container within, List<MapView> found) {
        for (Component part : within.getComponents()) {
            if (part instanceof MapView map) {
                found.add(map);
            } else if (part instanceof Container container) {
                collect(container, found);
            }
        }
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
                SampleDomain.CHOICE.choose(new Interaction(Purpose.SELECT, Map.of("answer", type), List.of(WITH_MAPS))),
                SampleDomain.EDITORS);
    }
}
