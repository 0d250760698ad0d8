package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Reads parts of a plan that stand by themselves in another document, such as the requirements of one edge, as {@link ProjectReader} reads
 * them in a project. Pointers of findings are relative to the part.
 */
public final class PartReader {
    private final Vocabulary vocabulary;

    /** A reader of parts of plans of one domain; has no state of its own. */
    public PartReader(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** Reads the requirements of an edge from a place to a transition. */
    public Reading<List<InRequirement>> inRequirements(JsonNode list) {
        RequirementReader reader = new RequirementReader();
        return list(list, reader::in);
    }

    /** Reads the requirements of an edge from a transition to a place. */
    public Reading<List<OutRequirement>> outRequirements(JsonNode list) {
        RequirementReader reader = new RequirementReader();
        return list(list, reader::out);
    }

    /** Reads from where a field of an output event comes. */
    public Reading<FieldSource> source(JsonNode node, FieldType field) {
        Problems problems = new Problems();
        PlanParts parts = new PlanParts(vocabulary, problems);
        return reading(
                new EventSpecReader(parts, new Names(problems)).source(new JsonObjectReader.Element(node, ""), field),
                problems);
    }

    /**
     * Reads the values of fields.
     *
     * @param declared the fields that there are
     * @param owner of the fields in the words of a message, such as {@code event ProxyCompleted}
     */
    public Reading<Map<String, Value>> values(JsonNode object, List<FieldType> declared, String owner) {
        return object(object, (parts, m) -> {
            Map<String, JsonObjectReader.Element> given = new LinkedHashMap<>();
            m.whole()
                    .properties()
                    .forEach(e -> given.put(e.getKey(), new JsonObjectReader.Element(e.getValue(), m.at(e.getKey()))));
            return Optional.of(parts.fields(given, declared, owner));
        });
    }

    /** Reads a markup: an object with {@code type} and {@code options}. */
    public Reading<MarkupSpec> markup(JsonNode object) {
        return object(object, PlanParts::markup);
    }

    /** Reads a task: an object with {@code name}, {@code class} and {@code fields}. */
    public Reading<TaskSpec> task(JsonNode object) {
        return object(object, (parts, m) -> parts.task(m, new Names(parts.problems())));
    }

    /** Reads a declared variable: an object with {@code name}, {@code type} and {@code initial}. */
    public Reading<VariableSpec> variable(JsonNode object) {
        return object(object, (parts, m) -> parts.variable(m, new Names(parts.problems())));
    }

    private <T> Reading<T> object(JsonNode node, BiFunction<PlanParts, JsonObjectReader, Optional<T>> read) {
        Problems problems = new Problems();
        PlanParts parts = new PlanParts(vocabulary, problems);
        return reading(JsonObjectReader.of(node, "", problems).flatMap(m -> read.apply(parts, m)), problems);
    }

    private static <T> Reading<List<T>> list(JsonNode node, Function<JsonObjectReader, Optional<T>> read) {
        Problems problems = new Problems();
        if (!node.isArray()) {
            problems.add(Codes.WRONG_TYPE, "", "A list is expected here, not " + JsonObjectReader.describe(node));
        }
        List<T> items = new ArrayList<>();
        for (int i = 0; i < node.size() && node.isArray(); i++) {
            JsonObjectReader.of(node.get(i), Problems.at("", i), problems)
                    .flatMap(read)
                    .ifPresent(items::add);
        }
        return reading(Optional.of(items), problems);
    }

    private static <T> Reading<T> reading(Optional<T> part, Problems problems) {
        return new Reading<>(problems.none() ? part : Optional.empty(), problems.findings());
    }
}
