package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.net.CompiledPlan;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;

/**
 * The fields of a plan that are asked when a mission starts: what was given, what is still to be asked.
 *
 * <p>Implements R-ACT-4.
 */
final class StartParameters {
    private final RuleStep step;
    private final VariableScopes declarations;
    private final CompiledPlan plan;
    private final Map<String, Value> given = new LinkedHashMap<>();
    private final Map<String, Value> variables = new LinkedHashMap<>();

    StartParameters(RuleStep step, VariableScopes declarations, CompiledPlan plan) {
        this.step = step;
        this.declarations = declarations;
        this.plan = plan;
    }

    /** Takes values by {@code eventId.field}, by a field's name where it is unique, or for variables by {@code @name}. */
    Optional<String> read(Map<String, Value> values) {
        for (Map.Entry<String, Value> e : values.entrySet()) {
            Optional<String> wrong = e.getKey().startsWith("@")
                    ? readVariable(e.getKey(), e.getValue())
                    : readField(e.getKey(), e.getValue());
            if (wrong.isPresent()) {
                return wrong;
            }
        }
        for (CompiledPlan.AskedField f : plan.asked) {
            if (!f.source().editable()) {
                f.source().defaultValue().ifPresent(v -> given.put(f.key(), v));
            }
        }
        return Optional.empty();
    }

    private Optional<String> readVariable(String name, Value value) {
        VariableSpec declared = plan.variables.get(name);
        if (declared == null) {
            declared = plan.project.globals.get(name);
        }
        if (declared == null) {
            return Optional.of("The plan '" + plan.plan.name() + "' knows no variable " + name);
        }
        if (!declarations.fits(declared, value)) {
            return Optional.of("The variable " + name + " cannot be " + value + ": it is of another type");
        }
        variables.put(name, value);
        return Optional.empty();
    }

    private Optional<String> readField(String key, Value value) {
        List<CompiledPlan.AskedField> fields = new ArrayList<>();
        for (CompiledPlan.AskedField f : plan.asked) {
            if (f.key().equals(key) || f.field().equals(key)) {
                fields.add(f);
            }
        }
        if (fields.isEmpty()) {
            return Optional.of("The plan '" + plan.plan.name() + "' asks for no parameter '" + key + "'");
        }
        if (fields.size() > 1) {
            return Optional.of("More than one parameter of '" + plan.plan.name() + "' is called '" + key + "'");
        }
        CompiledPlan.AskedField f = fields.get(0);
        if (!f.source().editable()) {
            return Optional.of("The parameter '" + key + "' is locked");
        }
        if (!TypeCheck.accepts(typeOf(f), value, step.project().vocabulary.types())) {
            return Optional.of("The parameter '" + key + "' cannot be " + value + ": it is of another type");
        }
        given.put(f.key(), value);
        return Optional.empty();
    }

    /** Gives what was not given its default; which has none, in words. */
    Optional<String> takeDefaults() {
        for (CompiledPlan.AskedField f : plan.asked) {
            if (!given.containsKey(f.key())) {
                if (f.source().defaultValue().isEmpty()) {
                    return Optional.of("The plan '" + plan.plan.name() + "' asks for '" + f.key()
                            + "' at its start: it has no default, so a value must be given");
                }
                given.put(f.key(), f.source().defaultValue().get());
            }
        }
        return Optional.empty();
    }

    /** Values by {@code eventId.field}: given ones and locked ones. */
    Map<String, Value> given() {
        return given.isEmpty() ? Map.of() : given; // a mission that waits keeps it: most plans ask nothing
    }

    Map<String, Value> variables() {
        return variables;
    }

    /** Whether an editable one was not given. */
    boolean mustAsk() {
        for (CompiledPlan.AskedField f : plan.asked) {
            if (!given.containsKey(f.key())) {
                return true;
            }
        }
        return false;
    }

    /** What is to be asked, with the locked ones for information. */
    List<Question.Item> items() {
        List<Question.Item> items = new ArrayList<>();
        for (CompiledPlan.AskedField f : plan.asked) {
            if (!f.source().editable() || !given.containsKey(f.key())) {
                items.add(new Question.Item(
                        f.key(),
                        typeOf(f),
                        f.output().field(f.field()).map(FieldType::unit).orElse(""),
                        f.source().defaultValue(),
                        f.source().editable(),
                        f.output().field(f.field()).map(FieldType::help).orElse("")));
            }
        }
        return items;
    }

    private static ValueType typeOf(CompiledPlan.AskedField f) {
        return f.output().field(f.field()).map(FieldType::type).orElse(ValueType.Simple.ANY);
    }
}
