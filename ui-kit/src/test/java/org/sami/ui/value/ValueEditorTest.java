package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.ui.value.SampleDomain.editor;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.IdentityMark;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;
import org.sami.ui.check.Layout;

/** Each component is answered once, through what it shows: its fields are typed into, its buttons pressed. */
class ValueEditorTest {
    private static void type(ValueEditor editor, String name, String text) {
        Layout.find(editor.component(), name, JTextComponent.class)
                .orElseThrow()
                .setText(text);
    }

    private static void press(ValueEditor editor, String name) {
        Layout.find(editor.component(), name, AbstractButton.class)
                .orElseThrow()
                .doClick();
    }

    private static Entry given(Value value) {
        return new Entry.Given(value);
    }

    @Test
    void libraryDeclaresWhatIsBuiltAndNothingElse() {
        assertThat(SampleDomain.LIBRARY.components().components()).isNotEmpty();
        assertThat(ComponentBuilders.differences(SampleDomain.LIBRARY.components()))
                .isEmpty();
    }

    @Test
    void aTextIsTyped() {
        ValueEditor note = editor("note", "text");

        type(note, "value-note-text", "on the way");

        assertThat(note.entry()).isEqualTo(given(new TextValue("on the way")));
    }

    @Test
    void aNumberIsTypedWithOrWithoutItsUnit() {
        ValueEditor spacing =
                SampleDomain.EDITORS.editor(new ValueField("spacing", "Spacing", ValueType.Simple.REAL, "m", ""));

        type(spacing, "value-spacing-text", "12,5 m");

        assertThat(spacing.entry()).isEqualTo(given(new RealValue(12.5)));
    }

    @Test
    void whatIsNoNumberIsToldAtItsField() {
        ValueEditor count = editor("count", "integer");
        JLabel message = Layout.find(count.component(), "value-count-message", JLabel.class)
                .orElseThrow();
        assertThat(message.getText()).isEqualTo("Enter a whole number, such as 10");

        type(count, "value-count-text", "a few");

        assertThat(count.entry().value()).isEmpty();
        assertThat(message.getText()).isEqualTo("▲ \"a few\" is not a whole number; one is 10");
    }

    @Test
    void typingIsUndoneAndMadeAgain() {
        ValueEditor note = editor("note", "text");
        note.show(new TextValue("before"));
        type(note, "value-note-text", "after");
        JTextComponent text = Layout.find(note.component(), "value-note-text", JTextComponent.class)
                .orElseThrow();

        text.getActionMap().get("undo-text").actionPerformed(null);
        text.getActionMap().get("undo-text").actionPerformed(null);
        assertThat(note.entry()).isEqualTo(given(new TextValue("before")));

        text.getActionMap().get("redo-text").actionPerformed(null);
        text.getActionMap().get("redo-text").actionPerformed(null);
        assertThat(note.entry()).isEqualTo(given(new TextValue("after")));
    }

    @Test
    void yesOrNoIsPressed() {
        ValueEditor approve = editor("approve", "boolean");
        assertThat(approve.entry().reason()).contains("Choose yes or no");

        press(approve, "value-approve-no");

        assertThat(approve.entry()).isEqualTo(given(new BooleanValue(false)));
    }

    @Test
    void aConstantIsChosen() {
        ValueEditor rank = editor("rank", "Rank");

        press(rank, "value-rank-option-3");

        assertThat(rank.entry()).isEqualTo(given(new EnumValue("Rank", "HIGH")));
    }

    @Test
    void proxiesAreChecked() {
        ValueEditor boats = editor("boats", "list<proxy>");

        press(boats, "value-boats-option-3");
        press(boats, "value-boats-option-1");

        assertThat(boats.entry())
                .isEqualTo(given(new ListValue(List.of(new ProxyValue("anna"), new ProxyValue("carla")))));
    }

    @Test
    void allProxiesThatAreShownAreCheckedAtOnce() {
        ValueEditor boats = editor("boats", "list<proxy>");

        press(boats, "value-boats-all");

        assertThat(((ListValue) boats.entry().value().orElseThrow()).items()).hasSize(4);
    }

    @Test
    void whatIsOfferedIsToldWithWhatIsKnownOfIt() {
        ProxyValue anna = new ProxyValue("anna");

        Offer known = SampleDomain.NAMES.known(Offer.one(List.of(
                new ChoiceRow(anna, "anna", ""),
                new ChoiceRow(anna, "anna", "SHORE"),
                new ChoiceRow(new ProxyValue("zoe"), "zoe", ""))));

        assertThat(known.rows())
                .extracting(ChoiceRow::detail)
                .containsExactly("82 % · path 3/9 · link 0.2 s", "SHORE", "");
        assertThat(known.rows().get(0).mark()).contains(new IdentityMark(0));
        assertThat(known.rows().get(2).mark()).isEmpty();
    }

    @Test
    void aTaskAVariableAndAPlanAreChosen() {
        ValueEditor task = editor("task", "task");
        ValueEditor variable = editor("variable", "variable");
        ValueEditor plan = editor("plan", "plan");

        press(task, "value-task-option-3");
        press(variable, "value-variable-option-2");
        press(plan, "value-plan-option-1");

        assertThat(task.entry()).isEqualTo(given(new TaskId(1, "Panorama")));
        assertThat(variable.entry()).isEqualTo(given(new VariableReference("@bay")));
        assertThat(plan.entry()).isEqualTo(given(new PlanReference("one")));
    }

    @Test
    void aListGrowsIsOrderedAndShrinks() {
        ValueEditor sensors = editor("sensors", "list<text>");
        press(sensors, "value-sensors-add");
        press(sensors, "value-sensors-add");
        press(sensors, "value-sensors-add");
        type(sensors, "value-sensors-1-text", "depth");
        type(sensors, "value-sensors-2-text", "salt");
        type(sensors, "value-sensors-3-text", "light");

        press(sensors, "value-sensors-up-3");
        press(sensors, "value-sensors-remove-1");

        assertThat(sensors.entry())
                .isEqualTo(given(new ListValue(List.of(new TextValue("light"), new TextValue("salt")))));
    }

    @Test
    void anUnknownRecordIsAForm() {
        ValueEditor boat = editor("boatId", "BoatId");
        type(boat, "value-boat-id-name-text", "anna");
        type(boat, "value-boat-id-server-text", "127.0.0.1:5001");

        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("name", new TextValue("anna"));
        fields.put("color", new TextValue(""));
        fields.put("server", new TextValue("127.0.0.1:5001"));
        fields.put("imageStorageDirectory", new TextValue(""));
        assertThat(boat.entry()).isEqualTo(given(new RecordValue("BoatId", fields)));
    }

    @Test
    void anEntryOfAMapNeedsItsKeyOnce() {
        ValueEditor words = editor("words", "map<proxy,text>");
        press(words, "value-words-add");
        assertThat(words.entry().reason()).contains("Entry 1: Choose one of 4");

        press(words, "value-words-1-key-option-2");
        press(words, "value-words-add");
        press(words, "value-words-2-key-option-2");

        assertThat(words.entry().reason()).contains("Entry 2: there is another entry for bert");
        press(words, "value-words-remove-2");
        assertThat(words.entry()).isEqualTo(given(new MapValue(Map.of(new ProxyValue("bert"), new TextValue("")))));
    }

    @Test
    void eachTaskGetsARobotOrNobody() {
        ValueEditor tasks = editor("tasks", "map<task,proxy>");

        Layout.find(tasks.component(), "value-tasks-task-2", JComboBox.class)
                .orElseThrow()
                .setSelectedItem("carla");

        assertThat(tasks.entry())
                .isEqualTo(given(new MapValue(Map.of(new TaskId(1, "Temperature 2"), new ProxyValue("carla")))));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            point       | 45.7, 10.72                          | 45.7, 10.72
            list<point> | 45.7, 10.72 / 45.8 10.73 at 3.5 m    | 45.7, 10.72 / 45.8, 10.73 at 3.5 m
            path        | 45.7, 10.72 / 45.8, 10.73            | 45.7, 10.72 / 45.8, 10.73
            area        | 45.7, 10.7 / 45.7, 10.8 / 45.8, 10.8 | 45.7, 10.7 / 45.7, 10.8 / 45.8, 10.8
            area        | 45, 10 / 45, 11 / 46, 11 / hole / 45.1, 10.5 / 45.2, 10.6 / 45.1, 10.6 | 45.0, 10.0 / 45.0, 11.0 / 46.0, 11.0 / hole / 45.1, 10.5 / 45.2, 10.6 / 45.1, 10.6
            list<area>  | 45, 10 / 45, 11 / 46, 11 / / 55, 10 / 55, 11 / 56, 11 | 45.0, 10.0 / 45.0, 11.0 / 46.0, 11.0 / / 55.0, 10.0 / 55.0, 11.0 / 56.0, 11.0
            """)
    void placesAreTypedAsCoordinates(String type, String typed, String written) {
        ValueEditor place = editor("place", type);

        type(place, "value-place-text", typed.replace(" / ", "\n").replace("/ ", "\n"));

        Value value = place.entry().value().orElseThrow();
        place.clear();
        place.show(value);
        assertThat(Layout.find(place.component(), "value-place-text", JTextComponent.class)
                        .orElseThrow()
                        .getText())
                .isEqualTo(written.replace(" / ", "\n").replace("/ ", "\n"));
        assertThat(place.entry()).isEqualTo(given(value));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            point | 95, 10                           | "95, 10" is not a place; one is 45.7, 10.72
            path  | 45, 10 / quay                    | Line 2: "quay" is not a place; one is 45.7, 10.72
            area  | 45, 10 / 45, 11                  | an area and a hole have three corners or more, not 2
            area  | 45, 10 / 46, 11 / 45, 11 / 46, 10 | The outline crosses itself between points 1 and 3: move one of them
            """)
    void whatIsNoPlaceIsTold(String type, String typed, String reason) {
        ValueEditor place = editor("place", type);

        type(place, "value-place-text", typed.replace(" / ", "\n"));

        assertThat(place.entry()).isEqualTo(Entry.wrong(reason));
    }

    @Test
    void aValueThatIsShownStaysItselfToItsLastDigit() {
        ValueEditor place = editor("place", "point");
        GeoPoint exact = new GeoPoint(45.70000000000001, -0.1 - 0.2, 1e-7);

        place.show(exact);

        assertThat(place.entry()).isEqualTo(given(exact));
        assertThat(place.isTouched()).isFalse();
    }

    @Test
    void aValueOfAnyTypeBeginsWithItsType() {
        ValueEditor any = editor("value", "any");
        Layout.find(any.component(), "value-value-type", JComboBox.class)
                .orElseThrow()
                .setSelectedItem("integer");

        type(any, "value-value-text", "7");
        assertThat(any.entry()).isEqualTo(given(new IntegerValue(7)));

        any.show(new EnumValue("Rank", "LOW"));
        assertThat(any.entry()).isEqualTo(given(new EnumValue("Rank", "LOW")));
    }

    @Test
    void aWarningStandsWhereNoComponentIsFound() {
        ValueEditor odd = SampleDomain.EDITORS.build(
                new ChosenComponent.Warning("No component can ask for it"), ValueField.of("odd", ValueType.Simple.ANY));

        assertThat(odd.entry()).isEqualTo(Entry.wrong("No component can ask for it"));
        assertThat(((JTextComponent) odd.component()).getText()).isEqualTo("▲ No component can ask for it");
    }

    @Test
    void whatTheProgramShowsIsNotTheOperatorsDoing() {
        ValueEditor boats = editor("boats", "list<proxy>");
        List<String> told = new ArrayList<>();
        boats.addListener(() -> told.add(String.valueOf(boats.isTouched())));

        boats.show(new ListValue(List.of(new ProxyValue("dora"))));
        press(boats, "value-boats-option-1");

        assertThat(told).containsExactly("false", "true");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"text", "real", "duration", "boolean", "Rank", "list<proxy>", "area", "BoatId", "list<text>"})
    void whatCanBeActedOnHasANameOfItsOwnAndAnAccessibleOne(String type) {
        ValueEditor one = editor("one", type);
        Set<String> names = new HashSet<>();

        for (Component component : below(one.component(), new ArrayList<>())) {
            if (component instanceof AbstractButton || component instanceof JTextComponent) {
                assertThat(component.getName()).as(component.toString()).startsWith("value-one");
                assertThat(names.add(component.getName()))
                        .as(component.getName())
                        .isTrue();
                assertThat(component.getAccessibleContext().getAccessibleName())
                        .as(component.getName())
                        .isNotBlank();
            }
        }
        assertThat(names).isNotEmpty();
    }

    private static List<Component> below(Container root, List<Component> all) {
        for (Component child : root.getComponents()) {
            if (child.getName() != null || !(child.getParent() instanceof javax.swing.JScrollBar)) {
                all.add(child);
            }
            if (child.isVisible() && child instanceof Container inner && !(child instanceof javax.swing.JScrollBar)) {
                below(inner, all);
            }
        }
        return all;
    }
}
