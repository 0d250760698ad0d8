package org.sami.ui.value;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.ui.geo.Coordinates;
import org.sami.ui.geo.GeoShape;
import org.sami.ui.geo.GeoSketch;

/**
 * Places as coordinates, a point a line, in any notation that {@link Coordinates} reads; written in decimal degrees with all their digits. A
 * height stands behind ({@code at 3.5 m}), the line {@code hole} begins a hole of an area, an empty line the next area of a list.
 */
enum PlacesText implements TypedText {
    POINT("point"),
    POINTS("list<point>"),
    PATH("path"),
    AREA("area"),
    AREAS("list<area>");

    private static final String HOLE = "hole";
    private static final Pattern HEIGHT = Pattern.compile("(.*?)\\s+at\\s+(-?\\d+(?:\\.\\d+)?)\\s*m");
    private static final int CORNERS = 3;

    private final ValueType type;

    PlacesText(String type) {
        this.type = TypeNames.parse(type).orElseThrow();
    }

    /** The form of a type; empty where it is no place. */
    static Optional<PlacesText> of(ValueType type) {
        for (PlacesText form : values()) {
            if (form.type.equals(type)) {
                return Optional.of(form);
            }
        }
        return Optional.empty();
    }

    /** What is drawn on a map for it; empty for several areas, which are only entered. */
    Optional<GeoShape> shape() {
        return switch (this) {
            case POINT -> Optional.of(GeoShape.POINT);
            case POINTS -> Optional.of(GeoShape.POINTS);
            case PATH -> Optional.of(GeoShape.PATH);
            case AREA -> Optional.of(GeoShape.AREA);
            case AREAS -> Optional.empty();
        };
    }

    @Override
    public Entry read(String text) {
        List<String> lines = text.lines().map(String::strip).toList();
        if (text.isBlank()) {
            return Entry.nothing(wanted());
        }
        List<List<List<GeoPoint>>> areas = new ArrayList<>(); // of each its outline and its holes
        areas.add(rings());
        for (int i = 0; i < lines.size(); i++) {
            String line = lines.get(i);
            List<List<GeoPoint>> rings = areas.get(areas.size() - 1);
            List<GeoPoint> ring = rings.get(rings.size() - 1);
            if (line.isEmpty()) {
                if (this == AREAS && !ring.isEmpty()) {
                    areas.add(rings());
                }
            } else if (line.equalsIgnoreCase(HOLE) && (this == AREA || this == AREAS)) {
                rings.add(new ArrayList<>());
            } else {
                Optional<GeoPoint> point = point(line);
                if (point.isEmpty()) {
                    return Entry.wrong((lines.size() > 1 ? "Line " + (i + 1) + ": " : "") + "\"" + Excerpt.of(line)
                            + "\" is not a place; one is 45.7, 10.72");
                }
                ring.add(point.get());
            }
        }
        areas.removeIf(rings -> rings.size() == 1 && rings.get(0).isEmpty());
        return this == AREA || this == AREAS
                ? areas(areas)
                : points(areas.get(0).get(0));
    }

    private static List<List<GeoPoint>> rings() {
        return new ArrayList<>(List.of(new ArrayList<>()));
    }

    private static Optional<GeoPoint> point(String line) {
        Matcher height = HEIGHT.matcher(line);
        return height.matches()
                ? Coordinates.parse(height.group(1))
                        .map(point -> new GeoPoint(point.latDeg(), point.lonDeg(), Double.parseDouble(height.group(2))))
                : Coordinates.parse(line);
    }

    private Entry points(List<GeoPoint> points) {
        return switch (this) {
            case POINT ->
                points.size() == 1 ? Entry.of(points.get(0)) : Entry.wrong("Enter one point, not " + points.size());
            case PATH -> Entry.of(new GeoPath(points));
            default -> Entry.of(new ListValue(List.copyOf(points)));
        };
    }

    private Entry areas(List<List<List<GeoPoint>>> areas) {
        List<Value> values = new ArrayList<>();
        for (List<List<GeoPoint>> rings : areas) {
            String which = areas.size() > 1 ? "Area " + (values.size() + 1) + ": " : "";
            for (List<GeoPoint> ring : rings) {
                if (ring.size() < CORNERS) {
                    return Entry.wrong(which + "an area and a hole have three corners or more, not " + ring.size());
                }
            }
            GeoArea area = new GeoArea(rings.get(0), rings.subList(1, rings.size()));
            GeoSketch sketch = new GeoSketch(GeoShape.AREA);
            sketch.show(area);
            if (sketch.problem().isPresent()) {
                return Entry.wrong(which + sketch.problem().get());
            }
            values.add(area);
        }
        return Entry.of(this == AREAS ? new ListValue(values) : values.get(0));
    }

    private String wanted() {
        return switch (this) {
            case POINT -> "Click the map, or enter it: 45.7, 10.72";
            case POINTS -> "Click points on the map, or enter one a line";
            case PATH -> "Click its points on the map, or enter one a line";
            case AREA -> "Click its corners on the map, or enter one a line";
            case AREAS -> "Enter the corners, one a line; an empty line begins the next area";
        };
    }

    @Override
    public String write(Value value) {
        StringBuilder text = new StringBuilder();
        if (value instanceof GeoPoint point) {
            append(text, List.of(point));
        } else if (value instanceof GeoPath path) {
            append(text, path.points());
        } else if (value instanceof GeoArea area) {
            return write(area.outline(), area.holes());
        } else {
            for (Value item : ((ListValue) value).items()) {
                if (item instanceof GeoArea area) {
                    text.append(text.isEmpty() ? "" : "\n\n").append(write(area.outline(), area.holes()));
                } else {
                    append(text, List.of((GeoPoint) item));
                }
            }
        }
        return text.toString().stripTrailing();
    }

    /** An outline that is not finished yet, or other points, and holes behind them. */
    static String write(List<GeoPoint> outline, List<List<GeoPoint>> holes) {
        StringBuilder text = new StringBuilder();
        append(text, outline);
        holes.forEach(hole -> {
            text.append(HOLE).append('\n');
            append(text, hole);
        });
        return text.toString().stripTrailing();
    }

    private static void append(StringBuilder text, List<GeoPoint> points) {
        for (GeoPoint point : points) {
            text.append(digits(point.latDeg())).append(", ").append(digits(point.lonDeg()));
            if (point.altM() != 0) {
                text.append(" at ").append(digits(point.altM())).append(" m");
            }
            text.append('\n');
        }
    }

    private static String digits(double number) {
        return number == 0 ? "0" : BigDecimal.valueOf(number).toPlainString();
    }

    @Override
    public String example() {
        return this == POINT ? "45.7, 10.72" : "";
    }

    @Override
    public int columns() {
        return this == POINT ? 24 : 0; // lines are as wide as what is written: no bar to scroll what is empty
    }

    @Override
    public boolean multiline() {
        return this != POINT;
    }
}
