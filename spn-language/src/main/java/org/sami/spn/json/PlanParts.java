package org.sami.spn.json;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads the parts that stand in several places of a project: variables, tasks, markups, values of declared fields. */
final class PlanParts {
    private final Vocabulary vocabulary;
    private final Problems problems;
    private final FieldTypeReader types;
    private final ValueReader values;

    PlanParts(Vocabulary vocabulary, Problems problems) {
        this.vocabulary = vocabulary;
        this.problems = problems;
        this.types = new FieldTypeReader(vocabulary.types(), problems);
        this.values = new ValueReader(vocabulary.types(), problems);
    }

    Vocabulary vocabulary() {
        return vocabulary;
    }

    Problems problems() {
        return problems;
    }

    Optional<Value> value(JsonObjectReader.Element element, ValueType type) {
        return values.read(element.node(), type, element.pointer());
    }

    List<VariableSpec> variables(JsonObjectReader m, String member) {
        Names taken = new Names(problems);
        return m.objects(member).stream()
                .map(v -> variable(v, taken))
                .flatMap(Optional::stream)
                .toList();
    }

    Optional<VariableSpec> variable(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        boolean goodName = checkVariable(name, m.at("name"));
        taken.take(name, m.at("name"));
        Optional<ValueType> type = types.type(m, "type");
        Optional<Value> initial = m.node("initial")
                .flatMap(n -> type.flatMap(t -> value(new JsonObjectReader.Element(n, m.at("initial")), t)));
        m.done();
        return goodName ? type.map(t -> new VariableSpec(name, t, initial)) : Optional.empty();
    }

    /** Whether a text can be the name of a variable that plans declare; it is reported where not. */
    boolean checkVariable(String name, String pointer) {
        if (name.isEmpty()) {
            return false;
        }
        if (!name.matches("@[A-Za-z][A-Za-z0-9_.]*")) {
            problems.add(
                    Codes.VARIABLE_NAME,
                    pointer,
                    "A variable's name is @ and a letter, then letters, digits, points: not \"" + name + "\"");
            return false;
        }
        if (name.equals(Reserved.TASK_VARIABLE)) {
            problems.add(Codes.VARIABLE_NAME, pointer, "@task is reserved: it reads a field from the entering task");
            return false;
        }
        return true;
    }

    List<MarkupSpec> markups(JsonObjectReader m) {
        return m.objects("markups").stream()
                .map(this::markup)
                .flatMap(Optional::stream)
                .toList();
    }

    Optional<MarkupSpec> markup(JsonObjectReader m) {
        String name = m.text("type");
        Optional<MarkupType> type = vocabulary.markup(name);
        Map<String, JsonObjectReader.Element> given = m.map("options");
        m.done();
        if (type.isEmpty()) {
            if (!name.isEmpty()) {
                List<String> alike = NearMatches.ofMarkups(vocabulary, name);
                String meant = alike.isEmpty() ? "" : "; is " + String.join(" or ", alike) + " meant?";
                m.problem(Codes.UNKNOWN_MARKUP, "type", "There is no markup \"" + name + "\"" + meant);
            }
            return Optional.empty();
        }
        Map<String, Value> options = new LinkedHashMap<>();
        given.forEach((option, element) -> {
            Optional<FieldType> declared = type.get().options().stream()
                    .filter(o -> o.name().equals(option))
                    .findFirst();
            if (declared.isEmpty()) {
                problems.add(
                        Codes.UNKNOWN_OPTION,
                        element.pointer(),
                        "The markup " + type.get().name() + " has no option \"" + option + "\""
                                + NearMatches.meant(
                                        type.get().options().stream()
                                                .map(FieldType::name)
                                                .toList(),
                                        option));
            }
            declared.flatMap(d -> value(element, d.type())).ifPresent(v -> options.put(option, v));
        });
        for (FieldType option : type.get().options()) {
            if (option.required() && !given.containsKey(option.name())) {
                m.problem(
                        Codes.MISSING,
                        "",
                        "The markup " + type.get().name() + " needs the option \"" + option.name() + "\"",
                        type.get().name());
            }
        }
        return Optional.of(new MarkupSpec(type.get().name(), options));
    }

    List<TaskSpec> tasks(JsonObjectReader m) {
        Names taken = new Names(problems);
        return m.objects("tasks").stream()
                .map(t -> task(t, taken))
                .flatMap(Optional::stream)
                .toList();
    }

    Optional<TaskSpec> task(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        taken.take(name, m.at("name"));
        String className = m.text("class");
        Map<String, JsonObjectReader.Element> given = m.map("fields");
        m.done();
        TaskClass taskClass = vocabulary.taskClasses().get(className);
        if (taskClass == null) {
            m.problem(
                    Codes.UNKNOWN_TASK,
                    "class",
                    "There is no task class \"" + className + "\""
                            + NearMatches.meant(vocabulary.taskClasses().keySet(), className),
                    name);
            return Optional.empty();
        }
        return Optional.of(new TaskSpec(name, className, fields(given, taskClass.fields(), "task class " + className)));
    }

    /** Values of declared fields; a field that is not declared is reported. */
    Map<String, Value> fields(Map<String, JsonObjectReader.Element> given, List<FieldType> declared, String owner) {
        Map<String, Value> fields = new LinkedHashMap<>();
        given.forEach((name, element) -> field(name, declared, owner, element.pointer())
                .flatMap(type -> value(element, type.type()))
                .ifPresent(v -> fields.put(name, v)));
        return fields;
    }

    Optional<FieldType> field(String name, List<FieldType> declared, String owner, String pointer) {
        Optional<FieldType> found =
                declared.stream().filter(f -> f.name().equals(name)).findFirst();
        if (found.isEmpty()) {
            List<String> names = declared.stream().map(FieldType::name).toList();
            String known = names.isEmpty() ? "it has none" : "it has " + String.join(", ", names);
            problems.add(
                    Codes.UNKNOWN_FIELD,
                    pointer,
                    "The " + owner + " has no field \"" + name + "\"; " + known + Suggestions.meant(names, name));
        }
        return found;
    }
}
