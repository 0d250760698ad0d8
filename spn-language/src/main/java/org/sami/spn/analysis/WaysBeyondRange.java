package org.sami.spn.analysis;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.GeographyMark;

/** A way that is known before the run is no longer than one charge of a robot, where the domain says how far that is. */
final class WaysBeyondRange implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-BEYOND-RANGE",
                "One charge does not last for the way: the robot stops on the water.",
                "Make the path shorter or the lanes wider, or divide the area among several robots."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        plan.vocabulary().geography().ifPresent(geography -> {
            GeoValues values = new GeoValues(plan);
            values.all().forEach(known -> check(known, known.value(), geography.rangeM(), report));
            for (PlacedOutput output : plan.outputs()) {
                lanes(output, values, geography.rangeM(), report);
            }
        });
    }

    private static void check(GeoValues.Known known, Value value, double rangeM, Consumer<Finding> report) {
        if (value instanceof GeoPath path) {
            check(known, "The path", path.points(), rangeM, report);
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> check(known, item, rangeM, report));
        } else if (value instanceof MapValue map) {
            for (Map.Entry<Value, Value> entry : map.entries().entrySet()) {
                if (entry.getValue() instanceof ListValue list) { // locations of one robot, in their order
                    List<GeoPoint> points = list.items().stream()
                            .filter(GeoPoint.class::isInstance)
                            .map(GeoPoint.class::cast)
                            .toList();
                    check(known, "The way through the locations", points, rangeM, report);
                } else {
                    check(known, entry.getValue(), rangeM, report);
                }
            }
        }
    }

    private static void check(
            GeoValues.Known known, String what, List<GeoPoint> way, double rangeM, Consumer<Finding> report) {
        double length = Distances.length(way);
        if (length > rangeM) {
            report.accept(Finding.warning(
                    "W-BEYOND-RANGE",
                    known.pointer(),
                    what + " in " + known.name() + " is " + Distances.inWords(length) + " long; one charge lasts for "
                            + Distances.inWords(rangeM) + ": divide it, or draw a recharge",
                    known.element()));
        }
    }

    private static void lanes(PlacedOutput output, GeoValues values, double rangeM, Consumer<Finding> report) {
        Optional<GeoValues.Known> area = marked(output, GeographyMark.LANES, values);
        Optional<Double> spacingM =
                marked(output, GeographyMark.LANE_SPACING, values).flatMap(known -> number(known.value()));
        if (area.isPresent()
                && area.get().value() instanceof GeoArea shape
                && spacingM.isPresent()
                && spacingM.get() > 0) {
            double length = Distances.squareMetres(shape) / spacingM.get();
            if (length > rangeM) {
                report.accept(Finding.warning(
                        "W-BEYOND-RANGE",
                        area.get().pointer(),
                        "The lanes in " + area.get().name() + " are about " + Distances.inWords(length)
                                + " long together; one charge lasts for " + Distances.inWords(rangeM)
                                + ": that takes at least " + (long) Math.ceil(length / rangeM)
                                + " robots or charges, or wider lanes",
                        output.spec().id()));
            }
        }
    }

    private static Optional<GeoValues.Known> marked(PlacedOutput output, GeographyMark mark, GeoValues values) {
        return output.type().fields().stream()
                .filter(field -> field.geography().equals(Optional.of(mark)))
                .map(FieldType::name)
                .findFirst()
                .flatMap(field -> values.of(output, field));
    }

    private static Optional<Double> number(Value value) {
        if (value instanceof RealValue real) {
            return Optional.of(real.value());
        }
        return value instanceof IntegerValue whole ? Optional.of((double) whole.value()) : Optional.empty();
    }
}
