package org.sami.spn.geotext;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** Makes variables of what a file says, once it is known what it means. */
public final class GeoVariables {
    private final GeoMeaning meaning;
    private final List<LineFinding> findings = new ArrayList<>();

    private GeoVariables(GeoMeaning meaning) {
        this.meaning = meaning;
    }

    /**
     * The variables, none where there are errors; and all that was found. One variable of the whole file, or, where each list
     * is to have its own, as many, with numbers from 1 at the ends of their names.
     */
    public record Result(List<VariableSpec> variables, List<LineFinding> findings) {
        public Result {
            variables = List.copyOf(variables);
            findings = List.copyOf(findings);
        }
    }

    /**
     * The variables of a text.
     *
     * @param name with its {@code @}
     * @param each whether each list has a variable of its own
     * @throws IllegalArgumentException if the text cannot have that meaning, for its brackets are of another depth
     */
    public static Result of(GeoText text, GeoMeaning meaning, String name, boolean each) {
        if (text.nesting() != meaning.nesting()) {
            throw new IllegalArgumentException(text.words() + " cannot be " + meaning.word());
        }
        GeoVariables maker = new GeoVariables(meaning);
        List<Value> values = new ArrayList<>();
        text.lists().forEach(list -> maker.value(list).ifPresent(values::add));
        if (maker.findings.stream().anyMatch(LineFinding::isError)) {
            return new Result(List.of(), maker.findings);
        }
        List<VariableSpec> variables = new ArrayList<>();
        if (meaning.nesting() < 2) {
            variables.add(new VariableSpec(name, meaning.type(), Optional.of(values.get(0))));
        } else if (each) {
            for (Value value : values) {
                String numbered = name + (variables.size() + 1);
                variables.add(new VariableSpec(numbered, meaning.ofOne().type(), Optional.of(value)));
            }
        } else {
            variables.add(new VariableSpec(name, meaning.type(), Optional.of(new ListValue(values))));
        }
        return new Result(variables, maker.findings);
    }

    private Optional<Value> value(GeoText.PointList list) {
        return switch (meaning) {
            case POINT -> point(list);
            case POINTS -> Optional.of(new ListValue(List.copyOf(list.points())));
            case PATH, PATHS -> path(list);
            case AREA, AREAS -> area(list);
        };
    }

    private Optional<Value> point(GeoText.PointList list) {
        if (list.points().size() > 1) {
            findings.add(LineFinding.error(
                    list.line(), "There are " + list.points().size() + " points; several stand in brackets"));
            return Optional.empty();
        }
        return Optional.of(list.points().get(0));
    }

    private Optional<Value> path(GeoText.PointList list) {
        List<GeoPoint> points = list.points();
        for (int i = 1; i < points.size(); i++) {
            if (points.get(i).equals(points.get(i - 1))) {
                findings.add(LineFinding.warning(
                        list.line(), "Point " + (i + 1) + " of this path is where point " + i + " is"));
            }
        }
        return Optional.of(new GeoPath(points));
    }

    /** An outline; one that is drawn back to its first point is that without the last. */
    private Optional<Value> area(GeoText.PointList list) {
        List<GeoPoint> outline = new ArrayList<>(list.points());
        if (outline.size() > 1 && outline.get(0).equals(outline.get(outline.size() - 1))) {
            outline.remove(outline.size() - 1);
        }
        Optional<String> wrong = Outlines.whyNoArea(outline);
        if (wrong.isPresent()) {
            findings.add(LineFinding.error(list.line(), wrong.get()));
            return Optional.empty();
        }
        return Optional.of(new GeoArea(outline, List.of()));
    }
}
