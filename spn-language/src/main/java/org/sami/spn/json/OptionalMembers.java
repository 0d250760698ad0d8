package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/** Puts members into objects that are left out where they would be empty or false. */
final class OptionalMembers {
    private OptionalMembers() {}

    static void putText(ObjectNode node, String member, String text) {
        if (!text.isEmpty()) {
            node.put(member, text);
        }
    }

    static void putFlag(ObjectNode node, String member, boolean flag) {
        if (flag) {
            node.put(member, true);
        }
    }

    static void putTexts(ObjectNode node, String member, List<String> texts) {
        if (!texts.isEmpty()) {
            ArrayNode array = node.putArray(member);
            texts.forEach(array::add);
        }
    }

    static void putTextMap(ObjectNode node, String member, Map<String, String> texts) {
        if (!texts.isEmpty()) {
            ObjectNode map = node.putObject(member);
            texts.forEach(map::put);
        }
    }

    static <T> void put(ObjectNode node, String member, List<T> items, Function<T, ObjectNode> writer) {
        if (!items.isEmpty()) {
            ArrayNode array = node.putArray(member);
            items.forEach(item -> array.add(writer.apply(item)));
        }
    }
}
