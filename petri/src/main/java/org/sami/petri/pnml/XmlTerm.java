package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.List;

/**
 * An element of a term or a declaration, with what stands in it.
 *
 * @param name of the element
 * @param id its attribute {@code id}; empty where it is absent, as with the other attributes
 * @param reference what it refers to: the attribute {@code declaration}, {@code refvariable} or {@code refpartition}
 * @param value its attribute {@code value}, {@code name} of colours and elements of partitions, or {@code start..end} of a range
 */
record XmlTerm(String name, String id, String reference, String value, List<XmlTerm> parts, int line) {
    XmlTerm {
        parts = List.copyOf(parts);
    }

    /** What people call it: its name, or its id where it has none. */
    String nameOrId() {
        return value.isEmpty() ? id : value;
    }

    /** The only element in it; refuses none and several. */
    XmlTerm only() throws RefusedPnmlException {
        if (parts.size() != 1) {
            throw new RefusedPnmlException(
                    "E-TERM", line, "in " + name + " stand " + parts.size() + " elements, expected is one");
        }
        return parts.get(0);
    }

    /** The terms in it, each taken out of its {@code subterm}. */
    List<XmlTerm> arguments(int count) throws RefusedPnmlException {
        if (parts.size() != count) {
            throw new RefusedPnmlException(
                    "E-TERM", line, name + " has " + parts.size() + " arguments, expected are " + count);
        }
        return arguments();
    }

    List<XmlTerm> arguments() throws RefusedPnmlException {
        List<XmlTerm> arguments = new ArrayList<>();
        for (XmlTerm part : parts) {
            arguments.add(part.name().equals("subterm") ? part.only() : part);
        }
        return arguments;
    }
}
