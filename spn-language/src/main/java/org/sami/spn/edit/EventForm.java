package org.sami.spn.edit;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/** What the reader would refuse of events: types, fields, values and markups that the vocabulary does not have. */
final class EventForm {
    private final Vocabulary vocabulary;
    private final Consumer<String> problem;

    EventForm(Vocabulary vocabulary, Consumer<String> problem) {
        this.vocabulary = vocabulary;
        this.problem = problem;
    }

    void output(OutputEventSpec spec) {
        type(spec.id(), spec.type(), Direction.OUTPUT).ifPresent(type -> {
            spec.fields().forEach((field, source) -> source(spec.id(), type, field, source));
            writes(spec.id(), type, spec.writes());
        });
        spec.markups().forEach(m -> markup(spec.id(), m));
    }

    void input(InputEventSpec spec) {
        type(spec.id(), spec.type(), Direction.INPUT).ifPresent(type -> {
            values(spec.fields(), type.fields(), "the event " + spec.id(), vocabulary, problem);
            writes(spec.id(), type, spec.writes());
        });
        spec.markups().forEach(m -> markup(spec.id(), m));
    }

    private Optional<EventType> type(String id, String name, Direction side) {
        Optional<EventType> type = vocabulary.event(name).filter(t -> t.direction() == side);
        if (type.isEmpty() || !type.get().name().equals(name)) {
            problem.accept("the event " + id + " is of the type " + name + ", which is no "
                    + (side == Direction.INPUT ? "input" : "output") + " event of the domain"
                    + type.map(t -> "; its name is " + t.name()).orElse(""));
        }
        return type;
    }

    private void source(String id, EventType type, String field, FieldSource source) {
        Optional<Value> value = source instanceof FieldSource.Fixed fixed
                ? Optional.of(fixed.value())
                : source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
        value(field, value, type.fields(), "the event " + id, vocabulary, problem);
        if (source instanceof FieldSource.FromVariable from) {
            VariableNameForm.problem(from.variable()).ifPresent(problem);
        }
    }

    private void writes(String id, EventType type, Map<String, String> writes) {
        writes.forEach((field, variable) -> {
            value(field, Optional.empty(), type.fields(), "the event " + id, vocabulary, problem);
            VariableNameForm.problem(variable).ifPresent(problem);
        });
    }

    private void markup(String id, MarkupSpec spec) {
        Optional<MarkupType> type = vocabulary.markup(spec.type());
        if (type.isEmpty() || !type.get().name().equals(spec.type())) {
            problem.accept("the event " + id + " has the markup " + spec.type() + ", which the domain does not have");
            return;
        }
        String owner = "the markup " + spec.type() + " of the event " + id;
        values(spec.options(), type.get().options(), owner, vocabulary, problem);
        type.get().options().stream()
                .filter(o -> o.required() && !spec.options().containsKey(o.name()))
                .forEach(o -> problem.accept(owner + " needs the option " + o.name()));
    }

    /** Tells fields that are not declared and values that are not of their field's type. */
    static void values(
            Map<String, Value> given,
            List<FieldType> declared,
            String owner,
            Vocabulary vocabulary,
            Consumer<String> problem) {
        given.forEach((name, value) -> value(name, Optional.of(value), declared, owner, vocabulary, problem));
    }

    private static void value(
            String name,
            Optional<Value> value,
            List<FieldType> declared,
            String owner,
            Vocabulary vocabulary,
            Consumer<String> problem) {
        Optional<FieldType> field =
                declared.stream().filter(f -> f.name().equals(name)).findFirst();
        if (field.isEmpty()) {
            problem.accept(owner + " has no field " + name);
        } else if (value.isPresent() && !TypeCheck.accepts(field.get().type(), value.get(), vocabulary.types())) {
            problem.accept("the value of " + name + " in " + owner + " is not of its type");
        }
    }
}
