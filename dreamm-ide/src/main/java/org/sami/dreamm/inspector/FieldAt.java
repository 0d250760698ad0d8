package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.ui.value.ValueSummary;

/**
 * A field of an event of the open plan, and the edits of it that its rows make.
 *
 * @param event the event's id
 * @param type the event's
 */
record FieldAt(DreammContext context, Scope scope, String event, EventType type, FieldType field) {
    static final String NEW_VARIABLE = ReadingChoice.NEW_VARIABLE;

    /** What the names of its components begin with. */
    String name() {
        return "field-" + field.name().replaceAll("([a-z0-9])([A-Z])", "$1-$2").toLowerCase(Locale.ROOT);
    }

    void apply(Edit edit) {
        context.apply(edit);
    }

    void set(FieldSource source) {
        apply(new FieldEdit.SetField(scope.plan().id(), event, field.name(), source));
    }

    void clear() {
        apply(new FieldEdit.ClearField(scope.plan().id(), event, field.name()));
    }

    /** What it means that nothing is given. */
    String nothing() {
        return field.defaultValue()
                .map(v -> "not given: " + ValueSummary.of(v))
                .orElse(field.required() ? "not given" : "not given, not needed");
    }

    /** The texts among which its value is chosen: the domain's classes of tasks, or the words that mean something; empty where any value can be given. */
    List<String> words() {
        if (field.type() != ValueType.Simple.TEXT) {
            return List.of();
        }
        return type.role() == EventRole.GENERATE_TASKS && field.name().equals(Reserved.TASK_CLASS)
                ? List.copyOf(context.vocabulary().taskClasses().keySet())
                : field.limits().words();
    }

    /** The variables that it can be written to, a new one last. */
    List<String> variables() {
        List<String> names = new ArrayList<>(scope.ofType(field.type()));
        names.add(NEW_VARIABLE);
        return names;
    }

    /** Makes an edit with a variable that was chosen; a new one is declared with it. */
    void with(String chosen, Function<String, Edit> use) {
        if (chosen.equals(NEW_VARIABLE)) {
            String fresh = scope.freshName(field.name());
            apply(scope.declaring(fresh, field.type(), use.apply(fresh)));
        } else {
            apply(use.apply(chosen));
        }
    }

    /** The value that a source gives, as far as it gives one. */
    static Optional<Value> value(FieldSource source) {
        return source instanceof FieldSource.Fixed fixed
                ? Optional.of(fixed.value())
                : source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
    }
}
