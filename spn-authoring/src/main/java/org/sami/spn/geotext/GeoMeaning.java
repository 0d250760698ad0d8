package org.sami.spn.geotext;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.spn.value.ValueType;

/** What the points of a file can mean: the type of the variable that is made of them. */
public enum GeoMeaning {
    POINT(0, ValueType.Simple.POINT),
    POINTS(1, new ValueType.ListOf(ValueType.Simple.POINT)),
    PATH(1, ValueType.Simple.PATH),
    AREA(1, ValueType.Simple.AREA),
    PATHS(2, new ValueType.ListOf(ValueType.Simple.PATH)),
    AREAS(2, new ValueType.ListOf(ValueType.Simple.AREA));

    private final int nesting;
    private final ValueType type;

    GeoMeaning(int nesting, ValueType type) {
        this.nesting = nesting;
        this.type = type;
    }

    /** How deep the brackets of such a file are. */
    public int nesting() {
        return nesting;
    }

    /** The variable's type. */
    public ValueType type() {
        return type;
    }

    /** The word on the command line. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The meaning of one list alone, where a file of several becomes several variables. */
    public GeoMeaning ofOne() {
        return this == PATHS ? PATH : this == AREAS ? AREA : this;
    }

    /** What brackets of that depth can mean. */
    public static List<GeoMeaning> of(int nesting) {
        return Arrays.stream(values()).filter(m -> m.nesting == nesting).toList();
    }

    /** The meaning that is of a type. */
    public static Optional<GeoMeaning> of(ValueType type) {
        return Arrays.stream(values()).filter(m -> m.type.equals(type)).findFirst();
    }

    /** Words to choose from: {@code paths or areas}. */
    public static String choices(int nesting) {
        return of(nesting).stream().map(GeoMeaning::word).collect(Collectors.joining(" or "));
    }
}
