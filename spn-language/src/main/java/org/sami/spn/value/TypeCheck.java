package org.sami.spn.value;

import java.util.Map;
import java.util.Objects;

/** Decides whether a value is of a type. */
public final class TypeCheck {
    private TypeCheck() {}

    /**
     * Whether a value is of a type.
     *
     * @param declarations the named types of the vocabulary, by name
     */
    public static boolean accepts(ValueType type, Value value, Map<String, NamedType> declarations) {
        if (type instanceof ValueType.Simple simple) {
            return acceptsSimple(simple, value);
        }
        if (type instanceof ValueType.ListOf list) {
            return value instanceof ListValue v
                    && v.items().stream().allMatch(item -> accepts(list.element(), item, declarations));
        }
        if (type instanceof ValueType.MapOf map) {
            return value instanceof MapValue v
                    && v.entries().entrySet().stream()
                            .allMatch(e -> accepts(map.key(), e.getKey(), declarations)
                                    && accepts(map.value(), e.getValue(), declarations));
        }
        return acceptsNamed(((ValueType.Named) type).name(), value, declarations);
    }

    private static boolean acceptsSimple(ValueType.Simple type, Value value) {
        return switch (type) {
            case BOOLEAN -> value instanceof BooleanValue;
            case INTEGER -> value instanceof IntegerValue;
            case REAL -> value instanceof RealValue || value instanceof IntegerValue;
            case TEXT -> value instanceof TextValue;
            case DURATION -> value instanceof DurationValue;
            case PROXY -> value instanceof ProxyValue;
            case TASK -> value instanceof TaskId;
            case POINT -> value instanceof GeoPoint;
            case PATH -> value instanceof GeoPath;
            case AREA -> value instanceof GeoArea;
            case VARIABLE -> value instanceof VariableReference;
            case PLAN -> value instanceof PlanReference;
            case ANY -> true;
        };
    }

    private static boolean acceptsNamed(String name, Value value, Map<String, NamedType> declarations) {
        NamedType declared = declarations.get(name);
        if (declared instanceof NamedType.Enumeration enumeration) {
            return value instanceof EnumValue v
                    && v.type().equals(name)
                    && enumeration.constants().contains(v.constant());
        }
        if (declared instanceof NamedType.RecordType type) {
            return value instanceof RecordValue v
                    && v.type().equals(name)
                    && v.fields().keySet().equals(type.fields().keySet())
                    && type.fields().entrySet().stream()
                            .allMatch(f -> accepts(
                                    f.getValue(),
                                    Objects.requireNonNull(v.fields().get(f.getKey()), f.getKey()),
                                    declarations));
        }
        return false;
    }
}
