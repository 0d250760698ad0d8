package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Objects;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a vocabulary declares, as JSON for other programs: every member is there, defaults too, and an input event says which
 * output events it can answer. The members' names are those of the vocabulary's files.
 */
public final class VocabularyWriter {
    private final Vocabulary vocabulary;

    /** A writer of one vocabulary's words. */
    public VocabularyWriter(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** An event type. Of output events {@code answers} are the input events, of input events {@code causes} the output events. */
    public ObjectNode event(EventType event) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("name", event.name());
        node.put("direction", Words.of(event.direction()));
        texts(node, "aliases", event.aliases());
        node.put("label", event.label());
        node.put("help", event.help());
        node.put("tokens", Words.of(event.tokens()));
        fields(node, "fields", event.fields());
        if (event.direction() == Direction.OUTPUT) {
            texts(node, "answers", event.answers());
        } else {
            texts(node, "causes", causes(event));
        }
        texts(node, "flags", event.flags().stream().map(Words::of).sorted().toList());
        if (event.role() != EventRole.NONE) {
            node.put("role", Words.of(event.role()));
        }
        event.decision().ifPresent(decision -> decision(node.putObject("decision"), decision));
        return node;
    }

    /** A markup type. */
    public ObjectNode markup(MarkupType markup) {
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("name", markup.name());
        texts(node, "aliases", markup.aliases());
        node.put("label", markup.label());
        node.put("help", markup.help());
        fields(node, "options", markup.options());
        return node;
    }

    /** The output events that an input event can answer. */
    public List<String> causes(EventType event) {
        return vocabulary.events().values().stream()
                .filter(output -> output.answers().contains(event.name()))
                .map(EventType::name)
                .toList();
    }

    private void fields(ObjectNode node, String member, List<FieldType> fields) {
        ArrayNode list = node.putArray(member);
        for (FieldType field : fields) {
            ObjectNode json = list.addObject();
            json.put("name", field.name());
            json.put("type", TypeNames.of(field.type()));
            if (field.type() instanceof ValueType.Named named
                    && vocabulary.types().get(named.name()) instanceof NamedType.Enumeration words) {
                texts(json, "constants", words.constants());
            }
            json.put("unit", field.unit());
            json.put("required", field.required());
            field.defaultValue()
                    .ifPresent(value -> json.set("default", ValueJson.write(value, field.type(), vocabulary.types())));
            json.put("help", field.help());
        }
    }

    private static void decision(ObjectNode node, DecisionType decision) {
        node.put("form", Words.of(decision.form()));
        node.put("accepted", decision.accepted());
        if (!decision.rejected().isEmpty()) {
            node.put("rejected", decision.rejected());
        }
        node.put("autonomy", Words.of(decision.autonomy()));
    }

    private static void texts(ObjectNode node, String member, List<String> texts) {
        ArrayNode list = node.putArray(member);
        texts.forEach(list::add);
    }
}
