package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.value.JudgedDraft;
import org.sami.crw.gui.value.SidesPanel;
import org.sami.crw.operator.mission.EngineText;
import org.sami.palette.SemanticColor;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.session.api.RefusedException;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Ids;
import org.sami.spn.value.Value;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.WidthTrackingPanel;
import org.sami.ui.sheet.FileSheet;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.value.Entry;
import org.sami.ui.value.ValueEditor;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.value.ValueField;
import org.sami.ui.value.WrappedText;

/**
 * The global variables of the project while missions run: each with the editor of its type. A new value counts for missions at once, and goes
 * to the project's file when that is asked for. What is filled in and not set stays while another one is shown.
 */
final class GlobalsPanel extends JPanel {
    private final OperatorContext context;
    private final ValueEditors editors;
    private final LoadedProject file;
    private final RowTable<Row> table;
    private final JLabel title = new JLabel("Global variables");
    private final WrappedText about = new WrappedText("Select a variable to change it.");
    private final WrappedText problem = new WrappedText("");
    private final JPanel body = new JPanel(new BorderLayout());
    private final Command set;
    private final Command save;
    private Optional<GlobalsState> state = Optional.empty();
    private Optional<Edited> edited = Optional.empty();
    private final Map<String, Edited> left =
            new LinkedHashMap<>(); // filled in and not set when another row was selected
    private Map<String, Value> saved = Map.of();
    private boolean asking;

    /** A global as it is listed. */
    private record Row(VariableSpec global, String value, boolean differs, boolean unset) {
        String words() {
            return (differs ? "● " : "") + value + (unset ? ", filled in and not set" : "");
        }
    }

    /** The global that is edited. */
    private record Edited(VariableSpec global, ValueEditor editor, Optional<Value> shown, JudgedDraft judged) {}

    GlobalsPanel(OperatorContext context, ValueEditors editors, LoadedProject file) {
        super(new BorderLayout());
        this.context = context;
        this.editors = editors;
        this.file = file;
        setName("globals");
        table = new RowTable<>(
                "globals-table",
                "The project has no global variable.",
                row -> row.global().name(),
                List.of(
                        RowColumn.<Row>words(
                                        "Variable", 130, row -> row.global().name())
                                .colored(row -> row.differs() ? SemanticColor.ACCENT : SemanticColor.TEXT),
                        RowColumn.words("Value now", 0, Row::words)));
        table.addSelectionListener(this::edit);
        set = context.commands()
                .add(new Command("global-set", "Set the variable", this::set)
                        .withKey("ctrl shift G")
                        .withIcon("check")
                        .unless(this::whyNotSet));
        save = context.commands()
                .add(new Command("globals-save", "Save to the project", this::save)
                        .withKey("ctrl S")
                        .withIcon("file")
                        .unless(this::whyNotSave));
        title.setFont(Fonts.strong());
        CommandRow head = new CommandRow();
        head.left(title).right(new CommandButton(save));
        LookColors.border(head, () -> BorderFactory.createMatteBorder(0, 0, 1, 0, SemanticColor.BORDER.get()));
        add(head, BorderLayout.NORTH);
        add(parts());
        context.models().missions().addListener(now -> reload());
        reload();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            title.setFont(Fonts.strong());
        }
    }

    private JScrollPane parts() {
        about.setName("global-about");
        problem.setName("global-problem");
        problem.setColor(SemanticColor.CRITICAL);
        JScrollPane scroll = new JScrollPane(new WidthTrackingPanel(body));
        scroll.setBorder(BorderFactory.createEmptyBorder());
        JPanel one = new JPanel(new MigLayout(
                "novisualpadding, insets 8 12 8 12, gap 4 8, fill, hidemode 3, wrap 1",
                "[grow,fill]",
                "[][grow,fill][][]"));
        one.add(about, "wmin 60");
        one.add(scroll, "hmin 80");
        one.add(problem, "wmin 60");
        one.add(new CommandButton(set), "growx 0");
        return WidthTrackingPanel.fromLeastHeight(new SidesPanel(table, one));
    }

    /** Asks the engine again; at most one question is under way. */
    void reload() {
        if (!asking) {
            asking = true;
            context.shown().ask(GlobalsState::of).whenComplete((told, fault) -> {
                asking = false;
                if (fault == null) {
                    show(told);
                }
            });
        }
    }

    private void show(GlobalsState told) {
        if (state.map(before -> !before.project().equals(told.project())).orElse(false)) {
            saved = Map.of(); // another project was loaded
        }
        GlobalsState now = told.withSaved(saved);
        state = Optional.of(now);
        left.values().removeIf(one -> !now.project().globals().contains(one.global()) || !isUnset(one));
        table.show(now.project().globals().stream()
                .map(global -> new Row(
                        global,
                        now.value(global).map(EngineText::value).orElse("has no value yet"),
                        now.differs(global),
                        left.containsKey(global.name())))
                .toList());
        title.setText(
                now.differing() == 0
                        ? "Global variables"
                        : "Global variables, " + now.differing() + " not as in the project");
        follow(now);
        refreshCommands();
    }

    /** What is edited follows what missions write, unless the operator has begun to change it. */
    private void follow(GlobalsState now) {
        edited.ifPresent(one -> {
            Optional<Value> value = now.value(one.global());
            if (!value.equals(one.shown()) && !one.editor().isTouched()) {
                edited = Optional.of(new Edited(one.global(), one.editor(), value, one.judged()));
                value.ifPresent(one.editor()::show);
            }
            tell(now, one.global(), one.editor(), one.judged());
        });
    }

    private void tell(GlobalsState now, VariableSpec global, ValueEditor editor, JudgedDraft judged) {
        String text = global.name() + ". " + now.readBy(global);
        if (!about.getText().equals(text)) {
            about.setText(text);
        }
        judged.look();
        Judgement said = judged.judgement();
        Optional<String> refused = editor.entry().reason().or(said::refusal);
        String wrong = !editor.isTouched()
                ? ""
                : refused.orElseGet(
                        () -> said.doubts().stream().map(words -> "△ " + words).collect(Collectors.joining("\n")));
        problem.setColor(refused.isPresent() ? SemanticColor.CRITICAL : SemanticColor.WARNING);
        problem.setText(wrong);
        problem.setVisible(!wrong.isEmpty());
    }

    private void edit() {
        Optional<Row> row = table.selected();
        if (row.isEmpty() || state.isEmpty()) {
            return;
        }
        VariableSpec global = row.get().global();
        if (edited.map(Edited::global).equals(Optional.of(global))) {
            return;
        }
        edited.filter(this::isUnset).ifPresent(one -> left.put(one.global().name(), one));
        Optional<Value> value = state.get().value(global);
        Edited next = Optional.ofNullable(left.remove(global.name()))
                .map(before -> new Edited(global, before.editor(), value, before.judged()))
                .orElseGet(() -> begun(global, value));
        edited = Optional.of(next);
        body.removeAll();
        body.add(next.editor().component());
        body.revalidate();
        body.repaint();
        tell(state.get(), global, next.editor(), next.judged());
        reload(); // the list says what is filled in and not set
        refreshCommands();
    }

    private Edited begun(VariableSpec global, Optional<Value> value) {
        ValueEditor editor = editors.editor(ValueField.of("global." + global.name(), global.type()));
        value.ifPresent(editor::show);
        editor.setEditable(context.whyNotAct().isEmpty());
        JudgedDraft judged = judged(global, editor);
        editor.addListener(() -> {
            state.ifPresent(now -> tell(now, global, editor, judged));
            refreshCommands();
        });
        return new Edited(global, editor, value, judged);
    }

    /** Whether the operator has filled in something else than the value that the global has. */
    private boolean isUnset(Edited one) {
        Entry entry = one.editor().entry();
        boolean something = entry.value().isPresent() || (entry instanceof Entry.Missing missing && missing.wrong());
        return one.editor().isTouched()
                && something
                && !entry.value().equals(state.flatMap(now -> now.value(one.global())));
    }

    /** The names of the globals for which something is filled in that is not set, in words; empty text where there is none. */
    private String unset() {
        return Stream.concat(left.values().stream(), edited.stream())
                .filter(this::isUnset)
                .map(one -> one.global().name())
                .distinct()
                .sorted()
                .collect(Collectors.joining(", "));
    }

    /** The judgement of a value before it is set; in a replay nothing is set. */
    private JudgedDraft judged(VariableSpec global, ValueEditor editor) {
        return new JudgedDraft(
                () -> editor.isTouched()
                        ? editor.entry()
                                .value()
                                .map(value -> DraftAnswer.of(Map.of(global.name(), value)))
                                .orElse(DraftAnswer.EMPTY)
                        : DraftAnswer.EMPTY,
                draft -> {
                    Value value = draft.values().get(global.name());
                    return value == null // taken back: there is nothing to judge
                            ? CompletableFuture.completedFuture(Judgement.NOTHING)
                            : context.session().drafts().judgeGlobal(global.name(), value);
                },
                () -> {
                    edited.filter(one -> one.editor() == editor)
                            .ifPresent(one -> state.ifPresent(now -> tell(now, global, editor, one.judged())));
                    set.refresh();
                });
    }

    private void refreshCommands() {
        set.refresh();
        save.refresh();
    }

    private Optional<String> whyNotSet() {
        if (edited.isEmpty()) {
            return Optional.of("select a variable in the table of globals first");
        }
        Edited one = edited.get();
        if (one.editor().entry().value().isEmpty()) {
            return one.editor().entry().reason();
        }
        return one.editor().entry().value().equals(one.shown())
                ? Optional.of(one.global().name() + " has this value already")
                : one.judged().isCurrent() ? one.judged().judgement().refusal() : Optional.empty();
    }

    private void set() {
        Edited one = edited.orElseThrow();
        Value value = one.editor().entry().value().orElseThrow();
        CompletionStage<Void> done =
                context.session().setVariable(Ids.NONE, one.global().name(), value);
        context.tell(done, one.global().name() + " is " + EngineText.value(value) + " now");
        done.thenRun(() -> {
            if (edited.map(Edited::editor).equals(Optional.of(one.editor()))) {
                edited = Optional.of(new Edited(one.global(), one.editor(), Optional.of(value), one.judged()));
                one.editor().show(value);
            }
            reload();
        });
    }

    private Optional<String> whyNotSave() {
        return state.map(GlobalsState::differing).orElse(0L) > 0
                ? context.whyNotHere()
                : Optional.of(
                        unset().isEmpty()
                                ? "all globals are as the project has them"
                                : "what is filled in for " + unset() + " is not set yet: set the variable first");
    }

    private void save() {
        file.path().ifPresentOrElse(this::save, this::saveAsFile);
    }

    private void saveAsFile() {
        String id = state.map(now -> now.project().id()).orElse("project");
        new FileSheet("globals-file", "Keep the project with these values in a file of its own")
                .toSave(Path.of(id + ".json"))
                .open(this, this::save);
    }

    /** Saves to the project's file; makes one where the project has none yet. */
    void save(Path to) {
        Map<String, Value> values = state.map(GlobalsState::values).orElse(Map.of());
        String notSet = unset().isEmpty() ? "" : "; not saved: what is filled in for " + unset() + " and not set";
        boolean isNew = file.path().isEmpty() && !Files.exists(to);
        CompletionStage<String> written = isNew
                ? context.here().project().save(to).thenApply(done -> "The project is in " + to + " now")
                : context.here()
                        .project()
                        .saveGlobals(to)
                        .thenApply(what -> what.changes().size() + " globals are saved to "
                                + to.getFileName()
                                + (what.warnings().isEmpty()
                                        ? ""
                                        : "; not saved: "
                                                + what.warnings().get(0).message()));
        written.whenComplete((text, fault) -> {
            if (fault == null) {
                file.set(to);
                saved = values;
                reload();
                context.notices().show(text + notSet);
            } else {
                context.notices().refused(RefusedException.reason(fault));
            }
        });
    }

    /** Selects a variable. */
    void select(String name) {
        table.selectKeys(Set.of(name));
        edit();
    }
}
