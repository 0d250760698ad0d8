package org.sami.ui.value;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.component.Interaction;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.Purpose;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** One of each component, with a value, without one, and with something wrong in it. Made again for each theme. */
final class Gallery {
    private Gallery() {}

    /** The components by name, each as it stands in a panel. */
    static Map<String, JComponent> components() {
        Map<String, JComponent> all = new LinkedHashMap<>();
        all.put("text", with("note", "text", "", new TextValue("Bring the sampler to the mouth of the river")));
        all.put("number", with("spacing", "real", "m", new RealValue(12.5)));
        all.put("number-wrong", typed("spacing", "real", "m", "twelve"));
        all.put(
                "number-missing",
                SampleDomain.editor("numberToCreate", "integer").component());
        all.put("duration", with("timeout", "duration", "", new DurationValue(5_430_000)));
        all.put("yes-no", with("approve", "boolean", "", new BooleanValue(true)));
        all.put("choice", with("rank", "Rank", "", new EnumValue("Rank", "HIGH")));
        all.put("proxies", with("boats", "list<proxy>", "", new ListValue(List.of(new ProxyValue("bert")))));
        all.put("proxy-filtered", filtered());
        all.put("variable", SampleDomain.editor("variable", "variable").component());
        all.put("plan", SampleDomain.editor("plan", "plan").component());
        all.put("task", SampleDomain.editor("task", "task").component());
        all.put("point", with("location", "point", "", GeoPoint.of(45.7012, 10.72)));
        all.put("area", with("area", "area", "", area()));
        all.put("area-missing", SampleDomain.editor("area", "area").component());
        all.put(
                "texts",
                with(
                        "sensors",
                        "list<text>",
                        "",
                        new ListValue(List.of(new TextValue("temperature"), new TextValue("depth")))));
        all.put("record", SampleDomain.editor("boatId", "BoatId").component());
        all.put(
                "entries",
                with(
                        "words",
                        "map<proxy,text>",
                        "",
                        new MapValue(Map.of(new ProxyValue("anna"), new TextValue("SHORE")))));
        all.put(
                "assignment",
                with(
                        "tasks",
                        "map<task,proxy>",
                        "",
                        new MapValue(Map.of(new TaskId(1, "Panorama"), new ProxyValue("dora")))));
        all.put("options-pager", options("SelectionOptions.format=SEQUENTIAL"));
        all.put("options-tabs", options("SelectionOptions.format=TABS"));
        all.put("options-stack", options("SelectionOptions.format=STACKED"));
        all.put("any", SampleDomain.editor("value", "any").component());
        all.put(
                "warning",
                new WarningView(
                                ValueField.of("odd", ValueType.Simple.ANY),
                                "No component can ask for a value of type map<odd,any>")
                        .component());
        return all;
    }

    private static JComponent with(String path, String type, String unit, Value value) {
        ValueEditor editor = SampleDomain.EDITORS.editor(field(path, type, unit));
        editor.show(value);
        return editor.component();
    }

    private static ValueField field(String path, String type, String unit) {
        return new ValueField(
                path, ValueField.words(path), TypeNames.parse(type).orElseThrow(), unit, "What it is for.");
    }

    private static JComponent typed(String path, String type, String unit, String text) {
        TextEditor editor = (TextEditor) SampleDomain.EDITORS.editor(field(path, type, unit));
        editor.type(text);
        return editor.component();
    }

    private static JComponent filtered() {
        ValueType type = TypeNames.parse("list<proxy>").orElseThrow();
        List<MarkupOption> filter = List.of(MarkupOption.parse("Filter.source").orElseThrow());
        return SampleDomain.EDITORS
                .chooser(
                        SampleDomain.CHOICE.choose(Purpose.SELECT, type, filter),
                        ValueField.of("choose", type),
                        new Offer(SampleDomain.NAMES.proxies(), 1, 2))
                .component();
    }

    private static JComponent options(String markup) {
        Question question = new Question.ChooseOption(List.of(
                SampleDomain.allocation("sequential auction", 812.4), SampleDomain.allocation("nearest first", 954.1)));
        ValueType type = TypeNames.parse("list<Allocation>").orElseThrow();
        Interaction wanted = new Interaction(
                Purpose.SELECT,
                Map.of("answer", type),
                List.of(MarkupOption.parse(markup).orElseThrow()));
        List<Value> values = ((Question.ChooseOption) question).options();
        QuestionEditor editor = new QuestionEditor(
                "allocation",
                question,
                List.of(
                        new OfferedRow(0, new ChoiceRow(values.get(0), "1", ""), true),
                        new OfferedRow(1, new ChoiceRow(values.get(1), "2", ""), false)),
                SampleDomain.CHOICE.choose(wanted),
                SampleDomain.EDITORS);
        return editor.component();
    }

    private static GeoArea area() {
        return new GeoArea(
                List.of(
                        GeoPoint.of(45.7, 10.72),
                        GeoPoint.of(45.7, 10.7225),
                        GeoPoint.of(45.7015, 10.7225),
                        GeoPoint.of(45.7015, 10.72)),
                List.of());
    }

    /** All of them below one another, each under its name. */
    static JPanel sheet() {
        JPanel sheet = new JPanel(
                new MigLayout("novisualpadding, insets 12, gap 12 8, fillx, wrap 2", "[120!][grow,fill]", "[top]"));
        components().forEach((name, component) -> {
            sheet.add(new NoteLabel(name));
            sheet.add(component);
        });
        return sheet;
    }
}
