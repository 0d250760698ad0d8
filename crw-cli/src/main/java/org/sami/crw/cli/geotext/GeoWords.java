package org.sami.crw.cli.geotext;

import java.util.List;
import java.util.Locale;
import org.sami.crw.service.Geodesy;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;

/** A variable's points, paths and areas in words, so that a wrong file is seen: how long, how large, where. */
public final class GeoWords {
    private GeoWords() {}

    /** A line for the variable, and one for each thing in it; with line feeds. */
    public static String text(VariableSpec variable) {
        StringBuilder text = new StringBuilder();
        text.append(variable.name()).append(": ").append(TypeNames.of(variable.type()));
        Value value = variable.initial().orElseThrow();
        if (value instanceof ListValue list) {
            text.append(", ").append(list.items().size()).append('\n');
            for (int i = 0; i < list.items().size(); i++) {
                text.append("  ").append(i + 1).append("  ");
                text.append(words(list.items().get(i))).append('\n');
            }
        } else {
            text.append(", ").append(words(value)).append('\n');
        }
        return text.toString();
    }

    private static String words(Value value) {
        if (value instanceof GeoPath path) {
            List<GeoPoint> points = path.points();
            double metres = Geodesy.lengthM(points.get(0), points);
            return String.format(Locale.ROOT, "%d points, %.1f m, from %s", points.size(), metres, at(points.get(0)));
        }
        if (value instanceof GeoArea area) {
            return String.format(
                    Locale.ROOT,
                    "%d points, %.0f m², from %s",
                    area.outline().size(),
                    Outlines.squareMetres(area),
                    at(area.outline().get(0)));
        }
        return at((GeoPoint) value);
    }

    private static String at(GeoPoint point) {
        return String.format(Locale.ROOT, "%.7f, %.7f", point.latDeg(), point.lonDeg());
    }
}
