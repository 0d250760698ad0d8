package org.sami.crw.handler.activation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.event.Numbers;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Reads fields of activations; what is missing or of another type is an {@link IllegalArgumentException} that names it. */
public final class ActivationFields {
    private ActivationFields() {}

    public static Value required(Activation activation, String field) {
        return activation
                .value(field)
                .orElseThrow(() -> new IllegalArgumentException(
                        activation.type() + " in " + activation.place() + " has no value for \"" + field + "\""));
    }

    public static String text(Activation activation, String field) {
        if (required(activation, field) instanceof TextValue text) {
            return text.value();
        }
        throw new IllegalArgumentException("\"" + field + "\" is no text: " + activation.value(field));
    }

    public static double metres(Activation activation, String field) {
        return number(activation, field);
    }

    public static double number(Activation activation, String field) {
        return Numbers.real(required(activation, field));
    }

    /** A field that may be left out. */
    public static Optional<Boolean> flag(Activation activation, String field) {
        return activation.value(field).map(value -> {
            if (value instanceof BooleanValue flag) {
                return flag.value();
            }
            throw new IllegalArgumentException("\"" + field + "\" is neither true nor false: " + value);
        });
    }

    public static GeoPoint point(Activation activation, String field) {
        return point(required(activation, field), field);
    }

    public static GeoPoint point(Value value, String field) {
        if (value instanceof GeoPoint point) {
            return point;
        }
        throw new IllegalArgumentException("\"" + field + "\" is no point: " + value);
    }

    public static List<GeoPoint> points(Value value, String field) {
        if (!(value instanceof ListValue list)) {
            throw new IllegalArgumentException("\"" + field + "\" is no list of points: " + value);
        }
        List<GeoPoint> points = new ArrayList<>();
        list.items().forEach(item -> points.add(point(item, field)));
        return points;
    }
}
