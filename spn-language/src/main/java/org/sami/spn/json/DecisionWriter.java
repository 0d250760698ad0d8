package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TypeNames;

/** Writes decisions for reports and tools. */
final class DecisionWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private DecisionWriter() {}

    static ObjectNode write(Decision d) {
        ObjectNode node = NODES.objectNode()
                .put("id", d.id())
                .put("mission", d.mission())
                .put("activation", d.activation())
                .put("type", d.type())
                .put("prompt", d.prompt());
        node.set("question", question(d.question()));
        d.automatic().ifPresent(a -> node.set("automatic", InputWriter.answer(a)));
        d.deadlineMillis().ifPresent(at -> node.put("deadlineMillis", at));
        node.put("priority", Words.of(d.priority()));
        node.set("markups", MarkupWriter.write(d.markups()));
        return node;
    }

    private static ObjectNode question(Question question) {
        ObjectNode node = NODES.objectNode();
        if (question instanceof Question.ChooseProxies q) {
            node.put("ask", "choose-proxies").put("min", q.min()).put("max", q.max());
            node.set("proxies", InputWriter.texts(q.proxies()));
        } else if (question instanceof Question.ChooseOption q) {
            ArrayNode options = node.put("ask", "choose-option").putArray("options");
            q.options().forEach(o -> options.add(TaggedValues.write(o)));
        } else if (question instanceof Question.FillIn q) {
            ArrayNode items = node.put("ask", "fill-in").putArray("items");
            q.items().forEach(i -> items.add(item(i)));
        } else {
            node.put("ask", "approve");
        }
        return node;
    }

    private static ObjectNode item(Question.Item item) {
        ObjectNode node = NODES.objectNode().put("key", item.key()).put("type", TypeNames.of(item.type()));
        if (!item.unit().isEmpty()) {
            node.put("unit", item.unit());
        }
        item.defaultValue().ifPresent(v -> node.set("default", TaggedValues.write(v)));
        return node.put("editable", item.editable()).put("help", item.help());
    }
}
