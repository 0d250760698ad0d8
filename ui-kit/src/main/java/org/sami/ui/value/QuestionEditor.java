package org.sami.ui.value;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.ui.geo.GeoSketch;

/**
 * Asks what a question asks, with the components that were chosen for it, and makes the answer of what they hold. Lives on the event
 * thread; the question stays the same, another one gets another editor.
 */
public final class QuestionEditor {
    private final Question question;
    private final List<OfferedRow> offered;
    private final Optional<FieldsPanel> form; // where values are filled in
    private final Optional<ValueEditor> single; // the editor of all other questions

    /**
     * An editor that shows what the question proposes.
     *
     * @param name begins the names of its components
     * @param offered the options in the order in which they are shown; empty for questions that offer none
     */
    public QuestionEditor(
            String name, Question question, List<OfferedRow> offered, ChosenComponent chosen, ValueEditors editors) {
        this.question = question;
        this.offered = List.copyOf(offered);
        if (question instanceof Question.FillIn fillIn) {
            form = Optional.of(fields(fillIn, chosen, editors));
            single = Optional.empty();
        } else {
            ValueEditor editor = question instanceof Question.Approve
                    ? editors.build(chosen, ValueField.of(name, ValueType.Simple.BOOLEAN))
                    : chooser(name, chosen, editors);
            editor.leaveMessage();
            single = Optional.of(editor);
            form = Optional.empty();
        }
    }

    private static FieldsPanel fields(Question.FillIn fillIn, ChosenComponent chosen, ValueEditors editors) {
        Map<String, ValueField> asked = new LinkedHashMap<>();
        fillIn.items().forEach(item -> asked.put(item.key(), ValueField.of(item)));
        FieldsPanel panel = editors.fields(chosen, asked);
        if (asked.size() == 1) {
            panel.editors().values().forEach(ValueEditor::leaveMessage);
        }
        for (Question.Item item : fillIn.items()) {
            ValueEditor editor = Objects.requireNonNull(panel.editors().get(item.key()), item.key());
            item.defaultValue().ifPresent(editor::show);
            if (!item.editable()) {
                editor.setEditable(false);
            }
        }
        return panel;
    }

    private ValueEditor chooser(String name, ChosenComponent chosen, ValueEditors editors) {
        List<ChoiceRow> rows = offered.stream().map(OfferedRow::row).toList();
        Offer offer = question instanceof Question.ChooseProxies proxies
                ? new Offer(rows, proxies.min(), Math.max(proxies.min(), proxies.max()))
                : Offer.one(rows);
        ValueType option = question instanceof Question.ChooseProxies ? ValueType.Simple.PROXY : ValueType.Simple.ANY;
        ValueChooser chooser = editors.chooser(chosen, ValueField.of(name, new ValueType.ListOf(option)), offer);
        List<Integer> selected = IntStream.range(0, offered.size())
                .filter(i -> offered.get(i).selected())
                .boxed()
                .toList();
        if (selected.size() <= offer.max()) {
            chooser.propose(selected);
        }
        return chooser;
    }

    /** What is put into a window. */
    public JComponent component() {
        return single.map(ValueEditor::component)
                .orElseGet(() -> form.orElseThrow().component());
    }

    /** Where the keyboard's focus goes first. */
    public JComponent focusTarget() {
        return single.map(ValueEditor::focusTarget)
                .orElseGet(() -> form.orElseThrow().focusTarget());
    }

    /** The answer that what is filled in makes; empty while something is missing. */
    public Optional<Answer> answer() {
        if (question instanceof Question.FillIn) {
            return form.orElseThrow().values().map(Answer.Fields::new);
        }
        ValueEditor editor = single.orElseThrow();
        if (editor.entry().value().isEmpty()) {
            return Optional.empty();
        }
        if (editor instanceof ValueChooser chooser) {
            return Optional.of(answer(chooser.chosen()));
        }
        return editor.entry()
                .value()
                .filter(BooleanValue.class::isInstance)
                .map(value -> new Answer.YesNo(((BooleanValue) value).value()));
    }

    private Answer answer(List<Integer> chosen) {
        return question instanceof Question.ChooseProxies
                ? new Answer.Proxies(chosen.stream()
                        .map(i -> ((ProxyValue) offered.get(i).row().value()).proxy())
                        .toList())
                : new Answer.Option(offered.get(chosen.get(0)).index());
    }

    /** Why there is no answer yet, in one line; empty where there is one. */
    public Optional<String> reason() {
        return single.map(editor -> editor.entry().reason())
                .orElseGet(() -> form.orElseThrow().missing().map(Entry.Missing::why));
    }

    /** Whether the operator has changed something: such an editor must not be replaced by another. */
    public boolean isTouched() {
        return single.map(ValueEditor::isTouched)
                .orElseGet(() -> form.orElseThrow().isTouched());
    }

    /** How many options can be chosen by number: two for yes and no, none where values are filled in. */
    public int options() {
        if (single.isEmpty()) {
            return 0;
        }
        return single.get() instanceof ValueChooser chooser ? chooser.options() : 2;
    }

    /**
     * Chooses an option by its number, which does not answer yet.
     *
     * @param option from 0; yes is 0 and no is 1
     */
    public void choose(int option) {
        if (option < 0 || option >= options()) {
            return;
        }
        if (single.orElseThrow() instanceof ValueChooser chooser) {
            chooser.choose(option);
        } else if (single.get() instanceof YesNoEditor yesNo) {
            yesNo.choose(option == 0);
        }
    }

    /**
     * The values that are chosen or filled in so far, such as to show them on a map. Of options that are compared it is the one that is looked at, and a single option also
     * before it is chosen.
     */
    public List<Value> values() {
        if (question instanceof Question.ChooseOption && offered.size() == 1) {
            return List.of(offered.get(0).row().value());
        }
        OptionalInt looked = looked();
        if (looked.isPresent()) {
            return List.of(offered.get(looked.getAsInt()).row().value());
        }
        return single
                .map(List::of)
                .orElseGet(() -> List.copyOf(form.orElseThrow().editors().values()))
                .stream()
                .flatMap(editor -> editor.entry().value().stream())
                .toList();
    }

    /** What is filled in so far, by the keys of the question's items; nothing where options are offered. */
    public Map<String, Value> given() {
        Map<String, Value> given = new LinkedHashMap<>();
        form.ifPresent(fields -> fields.editors()
                .forEach((key, editor) -> editor.entry().value().ifPresent(value -> given.put(key, value))));
        return given;
    }

    /** The offered values that are chosen now, also where too few or too many are. */
    public List<Value> chosen() {
        return chooser()
                .map(chooser -> chooser.chosen().stream()
                        .map(i -> offered.get(i).row().value())
                        .toList())
                .orElse(List.of());
    }

    /** Chooses an offered value as the operator does: of several, one that is chosen already is chosen no longer. Gives whether it is offered. */
    public boolean toggle(Value value) {
        for (int i = 0; i < offered.size(); i++) {
            if (offered.get(i).row().value().equals(value)) {
                choose(i);
                return true;
            }
        }
        return false;
    }

    /** Chooses these of what is offered, and no others; where one is to be chosen, it is the first of them. */
    public void chooseOnly(Collection<? extends Value> values) {
        for (int i = 0; i < offered.size(); i++) {
            boolean wanted = values.contains(offered.get(i).row().value());
            if (wanted != chosen().contains(offered.get(i).row().value())) {
                choose(i);
            }
        }
    }

    private Optional<ValueChooser> chooser() {
        return single.filter(ValueChooser.class::isInstance).map(ValueChooser.class::cast);
    }

    /** The option that is looked at, from 0, of several that a map can show; empty where none are compared. */
    public OptionalInt looked() {
        return chooser()
                .map(ValueChooser::looked)
                .filter(option -> offered.size() > 1)
                .orElse(OptionalInt.empty());
    }

    /**
     * Looks at another of the options that are compared, which chooses none.
     *
     * @param step how many further on; from the last it goes on to the first
     */
    public void look(int step) {
        OptionalInt looked = looked();
        looked.ifPresent(option ->
                chooser().ifPresent(chooser -> chooser.look(Math.floorMod(option + step, offered.size()))));
    }

    /** Calls a listener when another option is looked at ({@link #looked}). */
    public void onLooked(Runnable listener) {
        chooser().ifPresent(chooser -> chooser.onLooked(listener));
    }

    /** Shows the maps of the fields whose places can be drawn ({@link #sketch}), and those of options, or leaves them out where a large map has them. */
    public void useOwnMaps(boolean shown) {
        drawn().forEach(editor -> editor.useOwnMap(shown));
        chooser().ifPresent(editor -> editor.useOwnMap(shown));
    }

    /** What is drawn for the field in which the focus is; empty where it is in none that has a place. */
    public Optional<GeoSketch> focusedSketch() {
        Component focused =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        return drawn().stream()
                .filter(editor -> focused != null && SwingUtilities.isDescendingFrom(focused, editor.component()))
                .findFirst()
                .flatMap(ValueEditor::sketch);
    }

    private List<ValueEditor> drawn() {
        return form.map(fields -> fields.editors().values()).orElse(List.of()).stream()
                .filter(editor -> editor.sketch().isPresent())
                .toList();
    }

    /** What is drawn for the first field that has a place and no value yet, or else for the first that has a place; empty where none has. */
    public Optional<GeoSketch> sketch() {
        return drawn().stream()
                .filter(editor -> editor.entry().value().isEmpty())
                .findFirst()
                .or(() -> drawn().stream().findFirst())
                .flatMap(ValueEditor::sketch);
    }

    /**
     * Says of the robots that are offered what is known of them now. What the question itself says of one stays.
     *
     * @param robots those that are known
     */
    public void showNow(List<ChoiceRow> robots) {
        if (question instanceof Question.ChooseProxies && single.orElseThrow() instanceof ValueChooser chooser) {
            for (int i = 0; i < offered.size(); i++) {
                ChoiceRow row = offered.get(i).row();
                int option = i;
                if (row.detail().isEmpty()) {
                    robots.stream()
                            .filter(robot -> robot.value().equals(row.value()))
                            .findFirst()
                            .ifPresent(robot -> chooser.showDetail(option, robot.detail()));
                }
            }
        }
    }

    /** Adds a listener that is called after each change. */
    public void addListener(Runnable listener) {
        single.ifPresentOrElse(
                editor -> editor.addListener(listener), () -> form.orElseThrow().addListener(listener));
    }

    /** Calls a listener when yes or no was pressed, which is an answer without any further click. */
    public void onPressed(Runnable listener) {
        if (single.isPresent() && single.get() instanceof YesNoEditor yesNo) {
            yesNo.onPressed(listener);
        }
    }
}
