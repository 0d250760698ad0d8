package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * One JSON object of the export while it is read. In the export null means that nothing was set; it is read as absent. A
 * member of the wrong type is an error, and is then read as absent too, so that reading goes on to the next problem.
 */
final class Cursor {
    private final JsonNode node;
    private final String pointer;
    private final Findings findings;
    private final Set<String> known = new LinkedHashSet<>();

    private Cursor(JsonNode node, String pointer, Findings findings) {
        this.node = node;
        this.pointer = pointer;
        this.findings = findings;
    }

    static Optional<Cursor> of(JsonNode node, String pointer, Findings findings) {
        if (!node.isObject()) {
            findings.error(LegacyCodes.WRONG_TYPE, pointer, "An object is expected here, not " + describe(node));
            return Optional.empty();
        }
        return Optional.of(new Cursor(node, pointer, findings));
    }

    String pointer() {
        return pointer;
    }

    String at(String member) {
        return Findings.at(pointer, member);
    }

    void error(String code, String member, String message, String... elements) {
        findings.error(code, member.isEmpty() ? pointer : at(member), message, elements);
    }

    /** The object itself. */
    JsonNode whole() {
        return node;
    }

    Optional<JsonNode> node(String member) {
        known.add(member);
        return Optional.ofNullable(node.get(member)).filter(n -> !n.isNull());
    }

    /** A text that must be there; empty text after an error. */
    String text(String member) {
        Optional<JsonNode> found = node(member);
        if (found.isEmpty()) {
            error(LegacyCodes.MISSING, "", "The member \"" + member + "\" is missing");
        } else if (found.get().isTextual() && found.get().textValue().isEmpty()) {
            error(LegacyCodes.MISSING, member, "\"" + member + "\" is empty");
        }
        return text(member, "");
    }

    String text(String member, String absent) {
        return typed(member, JsonNode::isTextual, "text")
                .map(JsonNode::textValue)
                .orElse(absent);
    }

    boolean flag(String member) {
        return flag(member, false);
    }

    boolean flag(String member, boolean absent) {
        return typed(member, JsonNode::isBoolean, "true or false")
                .map(JsonNode::booleanValue)
                .orElse(absent);
    }

    int integer(String member, int absent) {
        return typed(member, n -> n.isIntegralNumber() && n.canConvertToInt(), "a whole number")
                .map(JsonNode::intValue)
                .orElse(absent);
    }

    double number(String member, double absent) {
        return typed(member, JsonNode::isNumber, "a number")
                .map(JsonNode::doubleValue)
                .orElse(absent);
    }

    List<Element> array(String member) {
        List<Element> elements = new ArrayList<>();
        JsonNode found = typed(member, JsonNode::isArray, "a list").orElse(MissingNode.getInstance());
        for (JsonNode item : found) {
            elements.add(new Element(item, at(member) + "/" + elements.size()));
        }
        return elements;
    }

    List<Cursor> objects(String member) {
        return array(member).stream()
                .map(e -> of(e.node(), e.pointer(), findings))
                .flatMap(Optional::stream)
                .toList();
    }

    List<String> texts(String member) {
        List<String> texts = new ArrayList<>();
        for (Element e : array(member)) {
            if (e.node().isTextual()) {
                texts.add(e.node().textValue());
            } else {
                findings.error(LegacyCodes.WRONG_TYPE, e.pointer(), "Text is expected here, not " + describe(e.node()));
            }
        }
        return texts;
    }

    /** The members of an object member that are set, in the file's order. */
    Map<String, Element> map(String member) {
        Map<String, Element> entries = new LinkedHashMap<>();
        JsonNode found = typed(member, JsonNode::isObject, "an object").orElse(MissingNode.getInstance());
        found.properties().forEach(e -> {
            if (!e.getValue().isNull()) {
                entries.put(e.getKey(), new Element(e.getValue(), Findings.at(at(member), e.getKey())));
            }
        });
        return entries;
    }

    Map<String, String> textMap(String member) {
        Map<String, String> texts = new LinkedHashMap<>();
        map(member).forEach((key, e) -> {
            if (e.node().isTextual()) {
                texts.put(key, e.node().textValue());
            } else {
                findings.error(LegacyCodes.WRONG_TYPE, e.pointer(), "Text is expected here, not " + describe(e.node()));
            }
        });
        return texts;
    }

    Optional<Cursor> object(String member) {
        return node(member).flatMap(n -> of(n, at(member), findings));
    }

    /** Names members that are in the format but have no counterpart here. */
    Cursor skip(String... members) {
        known.addAll(List.of(members));
        return this;
    }

    /** Warns of members that this version of the format does not have: what they say does not arrive. */
    void done() {
        for (Map.Entry<String, JsonNode> e : node.properties()) {
            if (!known.contains(e.getKey())) {
                findings.warning(
                        LegacyCodes.UNKNOWN_MEMBER,
                        at(e.getKey()),
                        "\"" + e.getKey() + "\" is not in version " + LegacyReader.VERSION
                                + " of the format; it is not imported");
            }
        }
    }

    private Optional<JsonNode> typed(String member, Predicate<JsonNode> right, String what) {
        Optional<JsonNode> found = node(member);
        if (found.isPresent() && !right.test(found.get())) {
            error(LegacyCodes.WRONG_TYPE, member, capital(what) + " is expected here, not " + describe(found.get()));
            return Optional.empty();
        }
        return found;
    }

    private static String capital(String words) {
        return Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    static String describe(JsonNode node) {
        return switch (node.getNodeType()) {
            case OBJECT -> "an object";
            case ARRAY -> "a list";
            case STRING -> "the text \"" + shorten(node.textValue()) + "\"";
            case NULL -> "null";
            default -> shorten(node.asText());
        };
    }

    private static String shorten(String text) {
        return text.length() <= 40 ? text : text.substring(0, 37) + "...";
    }

    /** A node and where it stands. */
    record Element(JsonNode node, String pointer) {}
}
