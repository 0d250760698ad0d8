package org.sami.spn.component;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/**
 * The types that a component can handle: one type, or with the name {@value #ANY_ENUMERATION} in it a type for each enumeration of
 * the domain. The thesis has six lists of classes; here a list's type is {@code list<T>} (its MCC and MSC) and a table's is
 * {@code map<K,V>} (its HCC and HSC), so that one list for each {@link Purpose} is enough.
 *
 * @param shape the type, in which the name may stand
 */
public record TypePattern(ValueType shape) {
    /** Stands for every enumeration. No domain can declare a type of this name. */
    public static final String ANY_ENUMERATION = "Enumeration";

    public TypePattern {
        Objects.requireNonNull(shape, "shape");
    }

    /** The pattern of a text such as {@code list<point>}, empty where the text is none. */
    public static Optional<TypePattern> parse(String text) {
        return TypeNames.parse(text).map(TypePattern::new);
    }

    /**
     * Whether a type is one of these.
     *
     * @param declarations the named types of the vocabulary, by name
     */
    public boolean matches(ValueType type, Map<String, NamedType> declarations) {
        return matches(shape, type, declarations);
    }

    private static boolean matches(ValueType shape, ValueType type, Map<String, NamedType> declarations) {
        if (shape instanceof ValueType.ListOf shapes && type instanceof ValueType.ListOf types) {
            return matches(shapes.element(), types.element(), declarations);
        }
        if (shape instanceof ValueType.MapOf shapes && type instanceof ValueType.MapOf types) {
            return matches(shapes.key(), types.key(), declarations)
                    && matches(shapes.value(), types.value(), declarations);
        }
        if (shape.equals(new ValueType.Named(ANY_ENUMERATION)) && type instanceof ValueType.Named named) {
            return declarations.get(named.name()) instanceof NamedType.Enumeration;
        }
        return shape.equals(type);
    }

    @Override
    public String toString() {
        return TypeNames.of(shape);
    }
}
