package org.sami.spn.json;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Finds where in a JSON text the values lie that pointers name, in one pass over its tokens for all of them. Whatever no pointer leads
 * to is skipped, so that a text without findings costs nothing and a long one little. A pointer to an absent value, such as a
 * missing member, gets the place of the nearest value around it.
 */
final class JsonPlaces {
    private static final List<String> NAMING = List.of("id", "name");

    private JsonPlaces() {}

    /**
     * Where a value begins.
     *
     * @param element the id (or else the name) of the innermost object around the value that has one, below the document itself;
     *     empty where there is none
     */
    record Place(int line, int column, Optional<String> element) {}

    /** The places of pointers in a text that was parsed before; empty where the text is not JSON. */
    static Map<String, Place> find(String text, Collection<String> pointers) {
        Step root = new Step();
        pointers.forEach(root::descend);
        try (JsonParser parser = JsonText.MAPPER.createParser(text)) {
            if (parser.nextToken() == null) {
                return Map.of();
            }
            root.visit(parser);
        } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
            return Map.of();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        root.element = Optional.empty(); // the document's own id says nothing about the place
        Map<String, Place> places = new HashMap<>();
        pointers.forEach(pointer -> places.put(pointer, root.place(pointer)));
        return places;
    }

    private static String[] steps(String pointer) {
        return pointer.isEmpty() ? new String[0] : pointer.substring(1).split("/", -1);
    }

    private static String plain(String step) {
        return step.replace("~1", "/").replace("~0", "~");
    }

    /** A value on the way to one that is asked for. */
    private static final class Step {
        private final Map<String, Step> children = new LinkedHashMap<>();
        private @Nullable JsonLocation location; // null until it is visited
        private Optional<String> element = Optional.empty();

        void descend(String pointer) {
            Step step = this;
            for (String name : steps(pointer)) {
                step = step.children.computeIfAbsent(plain(name), n -> new Step());
            }
        }

        /** Reads the value that begins at the parser's token, to its end. */
        void visit(JsonParser parser) throws IOException {
            location = parser.currentTokenLocation();
            boolean object = parser.currentToken() == JsonToken.START_OBJECT;
            if (!object && parser.currentToken() != JsonToken.START_ARRAY) {
                return;
            }
            int naming = NAMING.size();
            for (int index = 0; !parser.nextToken().isStructEnd(); index++) {
                String name = object ? parser.currentName() : Integer.toString(index);
                if (object) {
                    parser.nextToken();
                }
                int rank = object ? NAMING.indexOf(name) : -1;
                if (rank >= 0 && rank < naming && parser.currentToken() == JsonToken.VALUE_STRING) {
                    element = Optional.of(parser.getText());
                    naming = rank;
                }
                Step child = children.get(name);
                if (child == null) {
                    parser.skipChildren();
                } else {
                    child.visit(parser);
                }
            }
        }

        Place place(String pointer) {
            JsonLocation nearest = Objects.requireNonNull(location, "a place is asked for after the text was read");
            Optional<String> around = element;
            Step step = this;
            for (String name : steps(pointer)) {
                Step next = step.children.get(plain(name));
                if (next == null || next.location == null) {
                    break;
                }
                nearest = next.location;
                around = next.element.or(atLeast(around));
                step = next;
            }
            return new Place(nearest.getLineNr(), nearest.getColumnNr(), around);
        }

        private static java.util.function.Supplier<Optional<String>> atLeast(Optional<String> outer) {
            return () -> outer;
        }
    }
}
