package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;

/**
 * The values that fields of events and options of markups are known to have before a run: those that stand there, defaults of what is
 * asked, and first values of the variables that they read.
 */
final class KnownFields {
    private static final double MINUTE_S = 60;
    private static final double HOUR_S = 3600;
    private static final double MOST_EXACT = 1e15; // from there on doubles leave whole numbers out

    private final PlanContext plan;
    private final List<Known> all = new ArrayList<>();

    KnownFields(PlanContext plan) {
        this.plan = plan;
        plan.outputs().forEach(output -> all.addAll(of(plan, output)));
        plan.inputs().forEach(this::addInput);
    }

    /** All of a plan, in the order of the document: of places, then of transitions. */
    List<Known> all() {
        return all;
    }

    /** Those of one output event. */
    static List<Known> of(PlanContext plan, PlacedOutput output) {
        List<Known> known = new ArrayList<>();
        String where = plan.name(output);
        String event = output.spec().id();
        output.spec().fields().forEach((name, source) -> {
            Optional<FieldType> field = output.type().field(name);
            Optional<Value> value = value(plan, source);
            if (field.isPresent() && value.isPresent()) {
                known.add(new Known(
                        field.get(),
                        value.get(),
                        source instanceof FieldSource.FromVariable from
                                ? from.variable() + ", which " + name + " in " + where + " reads,"
                                : name + " in " + where,
                        output.pointer() + "/fields/" + name,
                        output.place().id(),
                        event,
                        rewriting(plan, event, name, source)));
            }
        });
        addMarkups(
                plan,
                known,
                output.spec().markups(),
                where,
                output.pointer(),
                output.place().id(),
                event);
        return known;
    }

    private void addInput(PlacedInput input) {
        String where = plan.name(input);
        String event = input.spec().id();
        input.spec()
                .fields()
                .forEach((name, value) -> input.type()
                        .field(name)
                        .ifPresent(field -> all.add(new Known(
                                field,
                                value,
                                name + " in " + where,
                                input.pointer() + "/fields/" + name,
                                input.transition().id(),
                                event,
                                other -> Optional.of(
                                        new FieldEdit.SetInputField(plan.plan().id(), event, name, other))))));
        addMarkups(
                plan,
                all,
                input.spec().markups(),
                where,
                input.pointer(),
                input.transition().id(),
                event);
    }

    private static void addMarkups(
            PlanContext plan,
            List<Known> known,
            List<MarkupSpec> markups,
            String where,
            String pointer,
            String vertex,
            String event) {
        for (int i = 0; i < markups.size(); i++) {
            MarkupSpec markup = markups.get(i);
            String at = pointer + "/markups/" + i + "/options/";
            plan.vocabulary()
                    .markup(markup.type())
                    .ifPresent(type -> type.options()
                            .forEach(option -> markup.option(option.name())
                                    .ifPresent(value -> known.add(new Known(
                                            option,
                                            value,
                                            option.name() + " of " + type.name() + " on " + where,
                                            at + option.name(),
                                            vertex,
                                            event,
                                            other -> Optional.empty())))));
        }
    }

    private static Optional<Value> value(PlanContext plan, FieldSource source) {
        if (source instanceof FieldSource.Fixed fixed) {
            return Optional.of(fixed.value());
        }
        if (source instanceof FieldSource.FromVariable from) {
            return Stream.concat(plan.plan().variables().stream(), plan.project().globals().stream())
                    .filter(v -> v.name().equals(from.variable()))
                    .findFirst()
                    .flatMap(VariableSpec::initial);
        }
        return source instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty();
    }

    private static Function<Value, Optional<Edit>> rewriting(
            PlanContext plan, String event, String field, FieldSource source) {
        return value -> {
            Optional<FieldSource> other = source instanceof FieldSource.Fixed
                    ? Optional.of(new FieldSource.Fixed(value))
                    : source instanceof FieldSource.Asked asked
                            ? Optional.of(new FieldSource.Asked(Optional.of(value), asked.editable()))
                            : Optional.empty();
            return other.map(s -> new FieldEdit.SetField(plan.plan().id(), event, field, s));
        };
    }

    /** The number of a value, of durations in seconds; empty where it is none. */
    static Optional<Double> number(Value value) {
        if (value instanceof RealValue real) {
            return Optional.of(real.value());
        }
        if (value instanceof DurationValue duration) {
            return Optional.of(duration.millis() / 1000.0);
        }
        return value instanceof IntegerValue whole ? Optional.of((double) whole.value()) : Optional.empty();
    }

    /** A number without needless digits, with the unit of its field: {@code 30 %}, {@code 0.5 s}, {@code 24 h}. */
    static String inWords(double number, FieldType field) {
        boolean duration = field.type() == ValueType.Simple.DURATION;
        if (duration && number >= HOUR_S && number % HOUR_S == 0) {
            return digits(number / HOUR_S) + " h";
        }
        if (duration && number >= MINUTE_S && number % MINUTE_S == 0) {
            return digits(number / MINUTE_S) + " min";
        }
        String unit = duration ? "s" : field.unit();
        return unit.isEmpty() ? digits(number) : digits(number) + " " + unit;
    }

    private static String digits(double number) {
        return number == Math.rint(number) && Math.abs(number) < MOST_EXACT
                ? String.format(Locale.ROOT, "%,.0f", number)
                : String.format(Locale.ROOT, "%.6f", number).replaceAll("0+$", "");
    }

    /**
     * One of them.
     *
     * @param name the field with its event and vertex, or the variable that it reads, as messages speak of it
     * @param rewriting the edit that puts another value there, where one can
     */
    record Known(
            FieldType field,
            Value value,
            String name,
            String pointer,
            String vertex,
            String event,
            Function<Value, Optional<Edit>> rewriting) {
        /** The number of the value, of durations in seconds. */
        Optional<Double> number() {
            return KnownFields.number(value);
        }

        /** The number with its unit. */
        String inWords(double number) {
            return KnownFields.inWords(number, field);
        }
    }
}
