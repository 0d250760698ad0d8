package org.sami.dreamm.inspector;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.Explained;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.value.ValueEditor;
import org.sami.ui.value.ValueField;

/** The markup of an event with its options, and what can be added. */
final class MarkupRows extends Form {
    private static final String ADD = "+ Markup…";

    private final transient DreammContext context;
    private final String plan;
    private final String event;

    MarkupRows(DreammContext context, String plan, String event, List<MarkupSpec> markups) {
        this.context = context;
        this.plan = plan;
        this.event = event;
        setName("event-markups");
        for (MarkupSpec markup : markups) {
            context.vocabulary().markup(markup.type()).ifPresent(type -> wide(new MarkupCard(markup, type)));
        }
        Map<String, MarkupType> others = new TreeMap<>();
        context.vocabulary().markups().values().stream()
                .filter(type -> markups.stream().noneMatch(m -> m.type().equals(type.name())))
                .forEach(type -> others.put(type.label(), type));
        JComboBox<String> add = new JComboBox<>();
        add.addItem(ADD);
        others.keySet().forEach(add::addItem);
        add.setName("event-add-markup");
        add.setToolTipText("Add markup: how the interaction is shown, ranked or answered");
        add.addActionListener(
                e -> Optional.ofNullable(others.get(add.getSelectedItem())).ifPresent(this::begin));
        wide(add);
    }

    private static String name(String markup) {
        return "markup-" + markup.replaceAll("([a-z0-9])([A-Z])", "$1-$2").toLowerCase(java.util.Locale.ROOT);
    }

    /** One markup that the event has. */
    private final class MarkupCard extends Form implements Explained {
        private final transient MarkupType type;

        MarkupCard(MarkupSpec markup, MarkupType type) {
            this.type = type;
            setName(MarkupRows.name(type.name()));
            JPanel head = new JPanel(new MigLayout("insets 4 0 0 0, gap 2, fillx", "[grow, fill][]"));
            head.setOpaque(false);
            JLabel title = new StrongLabel("◆ " + type.label());
            title.setToolTipText(type.help());
            head.add(title, "wmin 0");
            head.add(ProfileGuard.mark(
                    button(
                            "×",
                            MarkupRows.name(type.name()) + "-remove",
                            "Remove the markup " + type.label(),
                            () -> context.apply(new EventEdit.RemoveMarkup(plan, event, markup.type()))),
                    "markup-remove"));
            wide(head);
            note(type.help(), SemanticColor.MUTED);
            for (FieldType option : type.options()) {
                ValueEditor editor = context.values().editor(field(type, option));
                Optional<Value> value = markup.option(option.name()).or(option::defaultValue);
                option(this, option, new ValueRow(editor, value, v -> {
                    Map<String, Value> options = new LinkedHashMap<>(markup.options());
                    options.put(option.name(), v);
                    context.apply(new EventEdit.SetMarkup(plan, event, new MarkupSpec(markup.type(), options)));
                }));
            }
        }

        @Override
        public Optional<HelpTopic> help() {
            return Optional.of(
                    new HelpTopics(context.vocabulary(), context.additions().library()).markup(type));
        }
    }

    private static ValueField field(MarkupType type, FieldType option) {
        ValueField field = ValueField.of(option);
        return new ValueField(
                type.name() + "." + option.name(), field.label(), field.type(), field.unit(), field.help());
    }

    private static void option(Form form, FieldType option, ValueRow editor) {
        JLabel caption = new JLabel(ValueField.words(option.name()));
        caption.setToolTipText(option.help());
        form.add(caption, "span 2, growx, wmin 0");
        form.add(editor, "span 2, growx, wmin 0");
    }

    /** Adds a markup at once where all that it needs has a value, else asks for that first. */
    private void begin(MarkupType type) {
        List<FieldType> needed = type.options().stream()
                .filter(o -> o.required() && o.defaultValue().isEmpty())
                .toList();
        if (needed.isEmpty()) {
            Map<String, Value> options = new LinkedHashMap<>();
            type.options().stream()
                    .filter(FieldType::required)
                    .forEach(o -> o.defaultValue().ifPresent(v -> options.put(o.name(), v)));
            context.apply(new EventEdit.SetMarkup(plan, event, new MarkupSpec(type.name(), options)));
            return;
        }
        note(type.help(), SemanticColor.MUTED);
        Map<String, ValueEditor> editors = new LinkedHashMap<>();
        for (FieldType option : needed) {
            ValueEditor editor = context.values().editor(field(type, option));
            editors.put(option.name(), editor);
            option(this, option, new ValueRow(editor, Optional.empty(), v -> {}));
        }
        JButton add = button("Add " + type.label(), name(type.name()) + "-add", "Add the markup", () -> {
            Map<String, Value> options = new LinkedHashMap<>();
            editors.forEach((option, editor) -> editor.entry().value().ifPresent(v -> options.put(option, v)));
            context.apply(new EventEdit.SetMarkup(plan, event, new MarkupSpec(type.name(), options)));
        });
        Runnable check = () -> {
            Optional<String> missing = editors.values().stream()
                    .flatMap(e -> e.entry().reason().stream())
                    .findFirst();
            add.setEnabled(missing.isEmpty());
            add.setToolTipText(missing.orElse("Add the markup"));
        };
        editors.values().forEach(editor -> editor.addListener(check));
        check.run();
        wide(ProfileGuard.mark(add, "markup-add"));
        revalidate();
        repaint();
    }
}
