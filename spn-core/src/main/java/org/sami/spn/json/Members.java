package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Suggestions;

/**
 * The members of one JSON object being read. Each is asked for once; {@link #done()} reports those that nobody asked for.
 * A member of the wrong type is reported and read as if it were absent, so that reading goes on to the next problem.
 */
final class Members {
    private final JsonNode node;
    private final String pointer;
    private final Problems problems;
    private final Set<String> known = new LinkedHashSet<>();

    private Members(JsonNode node, String pointer, Problems problems) {
        this.node = node;
        this.pointer = pointer;
        this.problems = problems;
    }

    static Optional<Members> of(JsonNode node, String pointer, Problems problems) {
        if (!node.isObject()) {
            problems.add(Codes.WRONG_TYPE, pointer, "An object is expected here, not " + describe(node));
            return Optional.empty();
        }
        return Optional.of(new Members(node, pointer, problems));
    }

    String pointer() {
        return pointer;
    }

    String at(String member) {
        return Problems.at(pointer, member);
    }

    void problem(String code, String member, String message, String... elements) {
        problems.add(code, member.isEmpty() ? pointer : at(member), message, elements);
    }

    boolean has(String member) {
        return node.has(member);
    }

    /** The member as it stands. JSON's null is a value like others, and of the wrong type everywhere. */
    Optional<JsonNode> node(String member) {
        known.add(member);
        return Optional.ofNullable(node.get(member));
    }

    /** A text that must be there and not be empty; empty text after a problem. */
    String text(String member) {
        Optional<JsonNode> found = node(member);
        if (found.isEmpty()) {
            problem(Codes.MISSING, "", "The member \"" + member + "\" is missing");
            return "";
        }
        String text = asText(found.get(), at(member)).orElse("");
        if (found.get().isTextual() && text.isEmpty()) {
            problem(Codes.BAD_VALUE, member, "\"" + member + "\" must not be empty");
        }
        return text;
    }

    String text(String member, String absent) {
        return node(member).flatMap(n -> asText(n, at(member))).orElse(absent);
    }

    boolean flag(String member) {
        return flag(member, false);
    }

    boolean flag(String member, boolean absent) {
        Optional<JsonNode> found = node(member);
        if (found.isPresent() && !found.get().isBoolean()) {
            problem(Codes.WRONG_TYPE, member, "true or false is expected here, not " + describe(found.get()));
            return absent;
        }
        return found.map(JsonNode::booleanValue).orElse(absent);
    }

    int integer(String member, int absent) {
        Optional<JsonNode> found = node(member);
        if (found.isPresent() && !(found.get().isIntegralNumber() && found.get().canConvertToInt())) {
            problem(Codes.WRONG_TYPE, member, "A whole number is expected here, not " + describe(found.get()));
            return absent;
        }
        return found.map(JsonNode::intValue).orElse(absent);
    }

    /** A whole number that must be there; 0 after a problem. */
    long whole(String member) {
        Optional<JsonNode> found = node(member);
        if (found.isEmpty()) {
            problem(Codes.MISSING, "", "The member \"" + member + "\" is missing");
        } else if (!(found.get().isIntegralNumber() && found.get().canConvertToLong())) {
            problem(Codes.WRONG_TYPE, member, "A whole number is expected here, not " + describe(found.get()));
        }
        return found.map(JsonNode::longValue).orElse(0L);
    }

    /** A word that must be there. */
    <E extends Enum<E>> Optional<E> word(String member, Class<E> type) {
        String word = text(member);
        return word.isEmpty() ? Optional.empty() : parse(member, type, word);
    }

    <E extends Enum<E>> E word(String member, Class<E> type, E absent) {
        String word = text(member, "");
        return word.isEmpty() ? absent : parse(member, type, word).orElse(absent);
    }

    private <E extends Enum<E>> Optional<E> parse(String member, Class<E> type, String word) {
        Optional<E> constant = Words.parse(type, word);
        if (constant.isEmpty()) {
            problem(Codes.UNKNOWN_WORD, member, "\"" + word + "\"" + Words.noneOf(type, word));
        }
        return constant;
    }

    List<Element> array(String member) {
        List<Element> elements = new ArrayList<>();
        Optional<JsonNode> found = node(member);
        if (found.isPresent() && !found.get().isArray()) {
            problem(Codes.WRONG_TYPE, member, "A list is expected here, not " + describe(found.get()));
        } else if (found.isPresent()) {
            for (JsonNode item : found.get()) {
                elements.add(new Element(item, Problems.at(at(member), elements.size())));
            }
        }
        return elements;
    }

    List<Members> objects(String member) {
        return array(member).stream()
                .map(e -> of(e.node(), e.pointer(), problems))
                .flatMap(Optional::stream)
                .toList();
    }

    List<String> texts(String member) {
        return array(member).stream()
                .map(e -> asText(e.node(), e.pointer()))
                .flatMap(Optional::stream)
                .toList();
    }

    /** The members of an object member, in the file's order. */
    Map<String, Element> map(String member) {
        Map<String, Element> entries = new LinkedHashMap<>();
        Optional<JsonNode> found = node(member);
        if (found.isPresent() && !found.get().isObject()) {
            problem(Codes.WRONG_TYPE, member, "An object is expected here, not " + describe(found.get()));
        } else if (found.isPresent()) {
            found.get()
                    .properties()
                    .forEach(e ->
                            entries.put(e.getKey(), new Element(e.getValue(), Problems.at(at(member), e.getKey()))));
        }
        return entries;
    }

    Map<String, String> textMap(String member) {
        Map<String, String> texts = new LinkedHashMap<>();
        map(member).forEach((key, e) -> asText(e.node(), e.pointer()).ifPresent(text -> texts.put(key, text)));
        return texts;
    }

    Optional<Members> object(String member) {
        return node(member).flatMap(n -> of(n, at(member), problems));
    }

    /** Reports the members that nobody asked for. */
    void done() {
        for (Map.Entry<String, JsonNode> e : node.properties()) {
            if (!known.contains(e.getKey())) {
                problem(
                        Codes.UNKNOWN_MEMBER,
                        e.getKey(),
                        "\"" + e.getKey() + "\" is not known here; known are " + String.join(", ", known)
                                + Suggestions.meant(known, e.getKey()));
            }
        }
    }

    private Optional<String> asText(JsonNode found, String where) {
        if (found.isTextual()) {
            return Optional.of(found.textValue());
        }
        problems.add(Codes.WRONG_TYPE, where, "Text is expected here, not " + describe(found));
        return Optional.empty();
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
