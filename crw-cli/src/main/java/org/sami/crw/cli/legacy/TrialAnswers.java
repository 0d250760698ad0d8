package org.sami.crw.cli.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import org.sami.crw.decision.AnswersFile;
import org.sami.crw.decision.AnswersFileReader;
import org.sami.crw.decision.DomainQuestion;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Project;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The simulated operator's answers in trial runs, for values asked at the start that it cannot make up: a boat that
 * can be connected, and for any other field some value of its type, so that the plan goes on.
 */
final class TrialAnswers {
    private static final String SOME_DURATION = "PT10S";

    private final Vocabulary vocabulary;
    private final ArrayNode rules = JsonNodeFactory.instance.arrayNode();

    private TrialAnswers(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /**
     * Answers for all plans of a project.
     *
     * @param name what the boat is called
     * @param server where it is connected to
     */
    static AnswersFile of(String name, String server, Project project, Vocabulary vocabulary) {
        JsonNodeFactory values = JsonNodeFactory.instance;
        TrialAnswers answers = new TrialAnswers(vocabulary);
        answers.start("name", values.textNode(name), Optional.empty());
        answers.start("server", values.textNode(server), Optional.empty());
        project.plans()
                .forEach(plan -> plan.places()
                        .forEach(place -> place.outputs().forEach(output -> answers.add(output, plan.id()))));
        answers.rules // the plan is tried at its own places
                .addObject()
                .put("event", DomainQuestion.DOUBTFUL_WAY.kind())
                .putObject("answer")
                .put("yes", true);
        ObjectNode file = values.objectNode().put("format", "crw-answers").put("version", 1);
        file.set("rules", answers.rules);
        return AnswersFileReader.read(file.toString(), vocabulary).orThrow();
    }

    private void add(OutputEventSpec output, String plan) {
        output.fields().forEach((field, source) -> {
            if (source instanceof FieldSource.Asked asked
                    && asked.defaultValue().isEmpty()) {
                vocabulary
                        .event(output.type())
                        .flatMap(type -> type.field(field))
                        .map(FieldType::type)
                        .flatMap(this::someValue)
                        .ifPresent(value -> start(output.id() + "." + field, value, Optional.of(plan)));
            }
        });
    }

    private Optional<JsonNode> someValue(ValueType type) {
        JsonNodeFactory values = JsonNodeFactory.instance;
        if (type instanceof ValueType.Named named
                && vocabulary.types().get(named.name()) instanceof NamedType.Enumeration words) {
            return Optional.of(values.textNode(words.constants().get(0)));
        }
        if (!(type instanceof ValueType.Simple simple)) {
            return Optional.empty();
        }
        return switch (simple) {
            case INTEGER, REAL -> Optional.of(values.numberNode(1));
            case TEXT -> Optional.of(values.textNode("some text"));
            case DURATION -> Optional.of(values.textNode(SOME_DURATION));
            default -> Optional.empty();
        };
    }

    private void start(String item, JsonNode value, Optional<String> plan) {
        ObjectNode rule = rules.addObject();
        rule.put("event", "start:" + item);
        plan.ifPresent(id -> rule.put("plan", id));
        rule.putObject("answer").set("value", value);
    }
}
