package org.sami.spn.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.GeographyMark;

/**
 * No location lies where the plan itself forbids it: in an area that any of its events avoids, or outside that in which the event which
 * uses the location stays. Which fields hold such areas the vocabulary says ({@link GeographyMark}).
 */
final class AvoidedAreas implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "W-AVOIDED",
                        "The robot is sent into an area that the plan tells it to avoid: it refuses the path or "
                                + "stands at the edge.",
                        "Move the location out of the area, or make the area smaller."),
                new Advice(
                        "W-OUTSIDE",
                        "The location lies where its event does not let the robot go: it is never reached.",
                        "Move the location into the area, or make the area larger."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        GeoValues values = new GeoValues(plan);
        for (PlacedOutput output : plan.outputs()) {
            for (FieldType field : output.type().fields()) {
                Optional<GeoValues.Known> area = field.geography()
                        .filter(mark -> mark == GeographyMark.AVOID || mark == GeographyMark.WITHIN)
                        .flatMap(mark -> values.of(output, field.name()));
                if (area.isPresent() && field.geography().get() == GeographyMark.AVOID) {
                    values.all().forEach(known -> avoids(known, area.get(), report));
                } else if (area.isPresent()) {
                    output.type().fields().stream()
                            .flatMap(other -> values.of(output, other.name()).stream())
                            .forEach(known -> staysWithin(known, area.get(), report));
                }
            }
        }
    }

    private static void avoids(GeoValues.Known known, GeoValues.Known area, Consumer<Finding> report) {
        List<GeoArea> avoided = areas(area.value());
        List<Spot> inside = new ArrayList<>();
        known.locations((point, at) -> {
            if (avoided.stream().anyMatch(a -> Distances.contains(a, point))) {
                inside.add(new Spot(point, at));
            }
        });
        report(inside, known, "W-AVOIDED", "lies in the area of " + area.name() + ", which is to be avoided", report);
    }

    private static void staysWithin(GeoValues.Known known, GeoValues.Known area, Consumer<Finding> report) {
        List<GeoArea> allowed = areas(area.value());
        List<Spot> outside = new ArrayList<>();
        known.locations((point, at) -> {
            if (allowed.stream().noneMatch(a -> Distances.contains(a, point))) {
                outside.add(new Spot(point, at));
            }
        });
        report(outside, known, "W-OUTSIDE", "lies outside the area of " + area.name() + ", which is not left", report);
    }

    private static void report(
            List<Spot> spots, GeoValues.Known known, String code, String what, Consumer<Finding> report) {
        if (!spots.isEmpty()) {
            GeoPoint first = spots.get(0).point;
            String others = spots.size() == 1 ? "" : " (and " + (spots.size() - 1) + " more there)";
            report.accept(Finding.warning(
                    code,
                    spots.get(0).at,
                    "The location " + first.latDeg() + ", " + first.lonDeg() + " in " + known.name() + others + " "
                            + what + ": move it, or change the area",
                    known.element()));
        }
    }

    private static List<GeoArea> areas(Value value) {
        if (value instanceof GeoArea area) {
            return List.of(area);
        }
        return value instanceof ListValue list
                ? list.items().stream().flatMap(item -> areas(item).stream()).toList()
                : List.of();
    }

    private record Spot(GeoPoint point, String at) {}
}
