package org.sami.session.server;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.session.api.RefusedException;
import org.sami.spn.json.Reading;
import org.sami.spn.json.ValueJson;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.Value;

/** Reads answers to decisions (docs/session-link.md, Commands). What does not fit the question is refused in words. */
final class AnswerReader {
    private final Map<String, NamedType> types;

    AnswerReader(Map<String, NamedType> types) {
        this.types = types;
    }

    Answer read(Decision decision, JsonNode given) {
        Question question = decision.question();
        if (given.size() != 1) {
            throw new RefusedException("an answer has one member: yes, boats, option, none or fields");
        }
        if (question instanceof Question.Approve && given.path("yes").isBoolean()) {
            return new Answer.YesNo(given.path("yes").asBoolean());
        }
        boolean mayReject = question instanceof Question.ChooseOption || decision.isInterruptChoice();
        if (mayReject && given.path("none").asBoolean()) {
            return new Answer.Rejected();
        }
        if (question instanceof Question.ChooseProxies && given.path("boats").isArray()) {
            List<String> boats = new ArrayList<>();
            given.path("boats").forEach(boat -> boats.add(boat.asText()));
            return new Answer.Proxies(boats);
        }
        if (question instanceof Question.ChooseOption && given.path("option").isInt()) {
            return new Answer.Option(given.path("option").asInt());
        }
        if (question instanceof Question.FillIn fillIn && given.path("fields").isObject()) {
            return fields(fillIn, given.path("fields"));
        }
        throw new RefusedException(
                "this is no answer to decision " + decision.id() + ": expected is " + form(question));
    }

    private static String form(Question question) {
        if (question instanceof Question.Approve) {
            return "{\"yes\":true} or {\"yes\":false}";
        } else if (question instanceof Question.ChooseProxies) {
            return "{\"boats\":[...]}";
        }
        return question instanceof Question.ChooseOption
                ? "{\"option\":INDEX} or {\"none\":true}"
                : "{\"fields\":{...}}";
    }

    private Answer fields(Question.FillIn question, JsonNode given) {
        Map<String, Value> values = new LinkedHashMap<>();
        for (Question.Item item : question.items()) {
            if (!item.editable()) {
                continue;
            }
            JsonNode node = given.path(item.key());
            if (node.isMissingNode()) {
                item.defaultValue().ifPresent(value -> values.put(item.key(), value));
            } else {
                values.put(item.key(), value(item, node));
            }
        }
        for (Iterator<String> names = given.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (!values.containsKey(name)) {
                throw new RefusedException("'" + name + "' is not asked for");
            }
        }
        return new Answer.Fields(values);
    }

    private Value value(Question.Item item, JsonNode node) {
        Reading<Value> reading = ValueJson.read(node, item.type(), types);
        Optional<Value> value = reading.result();
        return value.orElseThrow(() -> new RefusedException(item.key() + ": "
                + (reading.findings().isEmpty()
                        ? "this is no value for it"
                        : reading.findings().get(0).message())));
    }
}
