package org.sami.boat.link;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import org.sami.boat.link.Checks.BadValueException;
import org.sami.boat.link.LinkException.Fault;

/**
 * The members of one received body, each read with its JSON type. Ranges are checked by the message that takes the
 * value.
 */
final class Fields {
    private final JsonNode object;
    private final String where; // of the object in the body

    Fields(JsonNode object) {
        this(object, "");
    }

    private Fields(JsonNode object, String where) {
        this.object = object;
        this.where = where;
    }

    String text(String name) throws LinkException {
        JsonNode node = member(name);
        if (!node.isTextual()) {
            throw wrongType(name, "a text");
        }
        return node.textValue();
    }

    /** A text that older peers leave out. */
    String textOrEmpty(String name) throws LinkException {
        return object.has(name) ? text(name) : "";
    }

    double number(String name) throws LinkException {
        return number(member(name), pointer(name));
    }

    double numberOr(String name, double absent) throws LinkException {
        return object.has(name) ? number(name) : absent;
    }

    static double number(JsonNode node, String where) throws LinkException {
        if (!node.isNumber()) {
            throw new LinkException(Fault.WRONG_TYPE, where, "not a number");
        }
        return node.doubleValue();
    }

    long integer(String name) throws LinkException {
        JsonNode node = member(name);
        if (!node.isIntegralNumber() || !node.canConvertToLong()) {
            throw wrongType(name, "a 64-bit integer");
        }
        return node.longValue();
    }

    /** A number that older peers leave out. */
    long integerOrZero(String name) throws LinkException {
        return object.has(name) ? integer(name) : 0;
    }

    int index(String name) throws LinkException {
        long value = integer(name);
        if (value != (int) value) {
            throw new LinkException(Fault.BAD_VALUE, pointer(name), value + " is no index");
        }
        return (int) value;
    }

    /** A flag that older peers leave out. */
    boolean flagOrFalse(String name) throws LinkException {
        return object.has(name) && flag(name);
    }

    boolean flag(String name) throws LinkException {
        JsonNode node = member(name);
        if (!node.isBoolean()) {
            throw wrongType(name, "true or false");
        }
        return node.booleanValue();
    }

    <E extends Enum<E>> E word(String name, Class<E> words) throws LinkException {
        String text = text(name);
        for (E word : words.getEnumConstants()) {
            if (word.name().equals(text)) {
                return word;
            }
        }
        throw new LinkException(Fault.BAD_VALUE, pointer(name), "not one of the words that are known here");
    }

    Fields object(String name) throws LinkException {
        JsonNode node = member(name);
        if (!node.isObject()) {
            throw wrongType(name, "an object");
        }
        return new Fields(node, pointer(name));
    }

    /** The objects of an array, of which there are so many at most. */
    List<Fields> objects(String name, int most) throws LinkException {
        JsonNode rows = array(name);
        if (rows.size() > most) {
            throw new LinkException(Fault.BAD_VALUE, pointer(name), rows.size() + " are more than " + most);
        }
        List<Fields> objects = new ArrayList<>(rows.size());
        for (int i = 0; i < rows.size(); i++) {
            String row = pointer(name) + "/" + i;
            if (!rows.get(i).isObject()) {
                throw new LinkException(Fault.WRONG_TYPE, row, "not an object");
            }
            objects.add(new Fields(rows.get(i), row));
        }
        return objects;
    }

    JsonNode array(String name) throws LinkException {
        return array(member(name), pointer(name));
    }

    static JsonNode array(JsonNode node, String where) throws LinkException {
        if (!node.isArray()) {
            throw new LinkException(Fault.WRONG_TYPE, where, "not an array");
        }
        return node;
    }

    boolean has(String name) {
        return object.has(name);
    }

    private JsonNode member(String name) throws LinkException {
        JsonNode node = object.get(name);
        if (node == null) {
            throw new LinkException(Fault.MISSING, pointer(name), "missing");
        }
        return node;
    }

    /** Where a member stands in the body. */
    String pointer(String name) {
        return where + "/" + name;
    }

    private LinkException wrongType(String name, String wanted) {
        return new LinkException(Fault.WRONG_TYPE, pointer(name), "not " + wanted);
    }

    /** What a part of a message said of a value that it refused. */
    LinkException refused(BadValueException refused) {
        return new LinkException(Fault.BAD_VALUE, pointer(refused.name()), refused.what());
    }

    /** What a message said of a value that it refused, as a fault of the frame. */
    static LinkException fault(BadValueException refused) {
        return new LinkException(Fault.BAD_VALUE, "/" + refused.name(), refused.what());
    }
}
