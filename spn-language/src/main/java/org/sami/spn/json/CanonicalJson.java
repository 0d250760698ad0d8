package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.Iterator;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.StreamSupport;

/**
 * The one way in which SAMI's files are laid out, so that a change of one element is a change of few lines: two spaces of
 * indentation; an object or list stands on one line where it fits, except that a list of several objects or lists, or of
 * anything with an id, has one line or group of lines for each.
 */
public final class CanonicalJson {
    private static final int WIDTH = 120;
    private static final String STEP = "  ";

    private CanonicalJson() {}

    /** The text of a document, with a line end after it. */
    public static String print(JsonNode document) {
        StringBuilder out = new StringBuilder();
        print(document, "", 0, true, out);
        return out.append('\n').toString();
    }

    /** The same document laid out canonically; members keep their order. Findings where the text is not JSON. */
    public static Reading<String> format(String text) {
        Problems problems = new Problems();
        return new Reading<>(JsonText.parse(text, problems).map(CanonicalJson::print), problems.findings());
    }

    private static void print(JsonNode node, String indent, int used, boolean root, StringBuilder out) {
        if (!root && mayBeInline(node)) {
            String line = inline(node);
            if (used + line.length() <= WIDTH) {
                out.append(line);
                return;
            }
        }
        if (node.isObject() && !node.isEmpty()) {
            printObject(node, indent, out);
        } else if (node.isArray() && !node.isEmpty()) {
            printArray(node, indent, out);
        } else {
            out.append(inline(node));
        }
    }

    private static void printObject(JsonNode node, String indent, StringBuilder out) {
        String inner = indent + STEP;
        out.append("{\n");
        for (Iterator<Map.Entry<String, JsonNode>> i = node.properties().iterator(); i.hasNext(); ) {
            Map.Entry<String, JsonNode> e = i.next();
            String key = quote(e.getKey()) + ": ";
            out.append(inner).append(key);
            print(e.getValue(), inner, inner.length() + key.length() + 1, false, out);
            out.append(i.hasNext() ? ",\n" : "\n");
        }
        out.append(indent).append('}');
    }

    private static void printArray(JsonNode node, String indent, StringBuilder out) {
        String inner = indent + STEP;
        out.append("[\n");
        for (Iterator<JsonNode> i = node.iterator(); i.hasNext(); ) {
            out.append(inner);
            print(i.next(), inner, inner.length() + 1, false, out);
            out.append(i.hasNext() ? ",\n" : "\n");
        }
        out.append(indent).append(']');
    }

    private static boolean mayBeInline(JsonNode node) {
        if (node.isArray()) {
            return node.size() <= 1
                    ? node.isEmpty()
                            || (mayBeInline(node.get(0)) && !node.get(0).has("id"))
                    : StreamSupport.stream(node.spliterator(), false).allMatch(JsonNode::isValueNode);
        }
        return StreamSupport.stream(node.spliterator(), false).allMatch(CanonicalJson::mayBeInline);
    }

    private static String inline(JsonNode node) {
        if (node.isObject()) {
            return node.properties().stream()
                    .map(e -> quote(e.getKey()) + ": " + inline(e.getValue()))
                    .collect(Collectors.joining(", ", "{", "}"));
        }
        if (node.isArray()) {
            return StreamSupport.stream(node.spliterator(), false)
                    .map(CanonicalJson::inline)
                    .collect(Collectors.joining(", ", "[", "]"));
        }
        return JsonText.text(node);
    }

    private static String quote(String text) {
        return JsonText.text(TextNode.valueOf(text));
    }
}
