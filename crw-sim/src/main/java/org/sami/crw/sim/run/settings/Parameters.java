package org.sami.crw.sim.run.settings;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ValueJson;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a plan asks at its start, by the names under which a value can be given beforehand: {@code event.field}, the
 * field's name alone where no other field has it, and variables with their {@code @}.
 */
public final class Parameters {
    private final Vocabulary vocabulary;
    private final Map<String, Parameter> byName = new LinkedHashMap<>();
    private final List<String> fields = new ArrayList<>();
    private final List<String> variables = new ArrayList<>();
    private final Map<String, Value> presets = new LinkedHashMap<>();

    private record Parameter(ValueType type, boolean editable) {}

    /**
     * What is known of a parameter before a run.
     *
     * @param name its full name
     * @param type the name of its type
     * @param preset its value where none is given, as a file has it; empty where the operator is asked, or a plan fills it
     * @param editable false = the author has locked it
     */
    public record Description(String name, String type, Optional<JsonNode> preset, boolean editable) {}

    /** The parameters of one plan of a project. */
    public Parameters(Vocabulary vocabulary, Project project, Plan plan) {
        this.vocabulary = vocabulary;
        Map<String, Integer> uses = new LinkedHashMap<>();
        for (Place place : plan.places()) {
            place.outputs().forEach(output -> addFields(output, uses));
        }
        uses.forEach((field, count) -> {
            if (count > 1) {
                byName.remove(field);
            }
        });
        plan.variables().forEach(this::addVariable);
        project.globals().forEach(this::addVariable);
    }

    private void addFields(OutputEventSpec output, Map<String, Integer> uses) {
        output.fields().forEach((field, source) -> {
            Optional<FieldType> declared = vocabulary.event(output.type()).flatMap(type -> type.field(field));
            if (source instanceof FieldSource.Asked asked && declared.isPresent()) {
                Parameter parameter = new Parameter(declared.get().type(), asked.editable());
                uses.merge(field, 1, Integer::sum);
                byName.put(output.id() + "." + field, parameter);
                byName.put(field, parameter);
                fields.add(output.id() + "." + field);
                asked.defaultValue().ifPresent(value -> presets.put(output.id() + "." + field, value));
            }
        });
    }

    private void addVariable(VariableSpec variable) {
        String name = variable.name().startsWith("@") ? variable.name() : "@" + variable.name();
        byName.putIfAbsent(name, new Parameter(variable.type(), true));
        variables.add(name);
        variable.initial().ifPresent(value -> presets.put(name, value));
    }

    /** The full names of the fields that are asked, in the plan's order. */
    public List<String> fields() {
        return List.copyOf(fields);
    }

    /** The names of variables, those of the plan and the project's. Most plans fill theirs themselves. */
    public List<String> variables() {
        return List.copyOf(variables);
    }

    /** The fields and the variables, in this order, each with its type. */
    public List<Description> describe() {
        return Stream.concat(fields.stream(), variables.stream())
                .map(this::describe)
                .toList();
    }

    private Parameter known(String name) {
        return Objects.requireNonNull(byName.get(name), name);
    }

    private Description describe(String name) {
        Parameter parameter = known(name);
        Optional<JsonNode> preset = Optional.ofNullable(presets.get(name))
                .map(value -> ValueJson.write(value, parameter.type(), vocabulary.types()));
        return new Description(name, TypeNames.of(parameter.type()), preset, parameter.editable());
    }

    /** The type of a parameter's values; empty where there is no such parameter. */
    public Optional<ValueType> type(String name) {
        return Optional.ofNullable(byName.get(name)).map(Parameter::type);
    }

    /** A value as a file has it, which {@link #read} reads again. */
    public String text(String name, Value value) {
        return ValueJson.write(value, known(name).type(), vocabulary.types()).toString();
    }

    /**
     * Reads values that were given as text.
     *
     * @throws IllegalArgumentException naming the first that is no parameter or whose text is no value of its type
     */
    public Map<String, Value> read(Map<String, String> texts) {
        Map<String, Value> values = new LinkedHashMap<>();
        texts.forEach((name, text) -> values.put(name, read(name, text)));
        return values;
    }

    private Value read(String name, String text) {
        Parameter parameter = byName.get(name);
        if (parameter == null) {
            List<String> known = new ArrayList<>(fields);
            known.addAll(variables);
            throw new IllegalArgumentException("the plan has no parameter '" + name + "'; "
                    + (known.isEmpty() ? "it asks nothing" : "it has " + String.join(", ", known)));
        }
        if (!parameter.editable()) {
            throw new IllegalArgumentException("'" + name + "' is locked by the plan's author");
        }
        List<Finding> findings = new ArrayList<>();
        return ValueText.parse(text, parameter.type(), vocabulary.types(), findings)
                .orElseThrow(() -> new IllegalArgumentException(
                        "'" + name + "' cannot be '" + text + "': " + reason(findings, parameter.type())));
    }

    private static String reason(List<Finding> findings, ValueType type) {
        String expected = "expected is " + ValueText.form(type);
        return findings.isEmpty() ? expected : expected + " (" + findings.get(0).message() + ")";
    }
}
