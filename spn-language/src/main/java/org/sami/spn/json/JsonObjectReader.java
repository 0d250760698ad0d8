package org.sami.spn.json;

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
import org.sami.spn.finding.Finding;

/**
 * Reads the members of one JSON object. Each is asked for once; {@link #done()} reports those that nobody asked for.
 * A member of the wrong type is reported and read as if it were absent, so that reading goes on to the next problem.
 */
public final class JsonObjectReader {
    private final JsonNode node;
    private final String pointer;
    private final Format format;
    private final Set<String> known = new LinkedHashSet<>();

    private JsonObjectReader(JsonNode node, String pointer, Format format) {
        this.node = node;
        this.pointer = pointer;
        this.format = format;
    }

    /** A reader of an object; empty, and reported, where the node is none. */
    public static Optional<JsonObjectReader> of(JsonNode node, String pointer, Format format) {
        if (!node.isObject()) {
            format.add(wrongType(pointer, "An object", node));
            return Optional.empty();
        }
        return Optional.of(new JsonObjectReader(node, pointer, format));
    }

    /** A pointer one step deeper, escaped after RFC 6901. */
    public static String at(String pointer, String member) {
        return pointer + "/" + member.replace("~", "~0").replace("/", "~1");
    }

    /** Where the object stands in its document. */
    public String pointer() {
        return pointer;
    }

    /** Where a member of the object stands. */
    public String at(String member) {
        return at(pointer, member);
    }

    /** Reports an error at a member, or at the object where the member is empty text. */
    public void problem(String code, String member, String message, String... elements) {
        format.add(Finding.error(code, member.isEmpty() ? pointer : at(member), message, elements));
    }

    /** The object itself. */
    public JsonNode whole() {
        return node;
    }

    /** Whether the object has a member of that name, whatever it holds. */
    public boolean has(String member) {
        return node.has(member);
    }

    /** The member as it stands. Whether JSON's null is a value like others, of the wrong type everywhere, the format says. */
    public Optional<JsonNode> node(String member) {
        known.add(member);
        return Optional.ofNullable(node.get(member)).filter(n -> !absent(n));
    }

    private boolean absent(JsonNode found) {
        return found.isNull() && format.nullIsAbsent();
    }

    private Optional<JsonNode> typed(String member, Predicate<JsonNode> right, String what) {
        Optional<JsonNode> found = node(member);
        if (found.isPresent() && !right.test(found.get())) {
            format.add(wrongType(at(member), what, found.get()));
            return Optional.empty();
        }
        return found;
    }

    /** A text that must be there and not be empty; empty text after a problem. */
    public String text(String member) {
        Optional<JsonNode> found = node(member);
        if (found.isEmpty()) {
            missing(member);
            return "";
        }
        String text = asText(found.get(), at(member)).orElse("");
        if (found.get().isTextual() && text.isEmpty()) {
            problem(format.emptyCode(), member, "\"" + member + "\" must not be empty");
        }
        return text;
    }

    private void missing(String member) {
        problem(Codes.MISSING, "", "The member \"" + member + "\" is missing");
    }

    /** A text that may be absent. */
    public String text(String member, String absent) {
        return node(member).flatMap(n -> asText(n, at(member))).orElse(absent);
    }

    /** True or false; false where it is absent. */
    public boolean flag(String member) {
        return flag(member, false);
    }

    /** True or false. */
    public boolean flag(String member, boolean absent) {
        return typed(member, JsonNode::isBoolean, "True or false")
                .map(JsonNode::booleanValue)
                .orElse(absent);
    }

    /** A whole number of 32 bits that may be absent. */
    public int integer(String member, int absent) {
        return typed(member, n -> n.isIntegralNumber() && n.canConvertToInt(), "A whole number")
                .map(JsonNode::intValue)
                .orElse(absent);
    }

    /** A whole number that must be there; 0 after a problem. */
    long whole(String member) {
        if (node(member).isEmpty()) {
            missing(member);
        }
        return typed(member, n -> n.isIntegralNumber() && n.canConvertToLong(), "A whole number")
                .map(JsonNode::longValue)
                .orElse(0L);
    }

    /** A number that may be absent. */
    public double number(String member, double absent) {
        return typed(member, JsonNode::isNumber, "A number")
                .map(JsonNode::doubleValue)
                .orElse(absent);
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

    /** The items of a list member. */
    public List<Element> array(String member) {
        List<Element> elements = new ArrayList<>();
        for (JsonNode item : typed(member, JsonNode::isArray, "A list").orElse(MissingNode.getInstance())) {
            elements.add(new Element(item, at(member) + "/" + elements.size()));
        }
        return elements;
    }

    /** The objects of a list member. */
    public List<JsonObjectReader> objects(String member) {
        return array(member).stream()
                .map(e -> of(e.node(), e.pointer(), format))
                .flatMap(Optional::stream)
                .toList();
    }

    /** The texts of a list member. */
    public List<String> texts(String member) {
        return array(member).stream()
                .map(e -> asText(e.node(), e.pointer()))
                .flatMap(Optional::stream)
                .toList();
    }

    /** The members of an object member, in the file's order. */
    public Map<String, Element> map(String member) {
        Map<String, Element> entries = new LinkedHashMap<>();
        JsonNode found = typed(member, JsonNode::isObject, "An object").orElse(MissingNode.getInstance());
        found.properties().forEach(e -> {
            if (!absent(e.getValue())) {
                entries.put(e.getKey(), new Element(e.getValue(), at(at(member), e.getKey())));
            }
        });
        return entries;
    }

    /** The texts of an object member, in the file's order. */
    public Map<String, String> textMap(String member) {
        Map<String, String> texts = new LinkedHashMap<>();
        map(member).forEach((key, e) -> asText(e.node(), e.pointer()).ifPresent(text -> texts.put(key, text)));
        return texts;
    }

    /** An object member. */
    public Optional<JsonObjectReader> object(String member) {
        return node(member).flatMap(n -> of(n, at(member), format));
    }

    /** Names members that are in the format but have no counterpart here. */
    public JsonObjectReader skip(String... members) {
        known.addAll(List.of(members));
        return this;
    }

    /** Reports the members that nobody asked for. */
    public void done() {
        for (Map.Entry<String, JsonNode> e : node.properties()) {
            if (!known.contains(e.getKey())) {
                format.add(format.unknownMember(at(e.getKey()), e.getKey(), known));
            }
        }
    }

    private Optional<String> asText(JsonNode found, String where) {
        if (found.isTextual()) {
            return Optional.of(found.textValue());
        }
        format.add(wrongType(where, "Text", found));
        return Optional.empty();
    }

    private static Finding wrongType(String pointer, String expected, JsonNode found) {
        return Finding.error(Codes.WRONG_TYPE, pointer, expected + " is expected here, not " + describe(found));
    }

    /** A node in the words of a message, shortened. */
    public static String describe(JsonNode node) {
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
    public record Element(JsonNode node, String pointer) {}

    /** Receives the findings about one document, and says in what its format differs from others. */
    public interface Format {
        /** Receives a finding. */
        void add(Finding finding);

        /** Whether JSON's null means that a member was not set. */
        boolean nullIsAbsent();

        /** The code of an empty text where one must be. */
        String emptyCode();

        /**
         * The finding about a member that nobody asked for.
         *
         * @param known the members that were asked for
         */
        Finding unknownMember(String pointer, String member, Set<String> known);
    }
}
