package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import org.sami.crw.service.choice.Criterion;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** What markups do to services. */
final class ServiceMarkupCases {
    private ServiceMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        catalogue.shows("SelectionOptions.number", "so many solutions are computed, none twice", () -> {
            assertThat(allocations(request())).hasSize(1);
            assertThat(allocations(request().marked("SelectionOptions", "number", new IntegerValue(2))))
                    .hasSize(2)
                    .doesNotHaveDuplicates();
        });
        for (Criterion criterion : Criterion.values()) {
            catalogue.shows(
                    "Optimize.criteria=" + criterion, "the best solution by it comes first, and says so", () -> {
                        RecordValue best =
                                (RecordValue) allocations(request().marked("Optimize", "criteria", criterion.name()))
                                        .get(0);
                        assertThat(((TextValue) best.fields().get("reason")).value())
                                .contains(criterion
                                        .name()
                                        .toLowerCase(Locale.ROOT)
                                        .replace('_', ' '));
                    });
        }
    }

    /** Two boats four and eight metres east of home: what is the nearest for each is not the best for both. */
    private static PlanSketch request() {
        List<GeoPoint> locations = List.of(PlanScene.at(6.1, 0), PlanScene.at(20, 0));
        return new PlanSketch()
                .variable("@allocations", "list<Allocation>")
                .on("ask", "AllocationResponse", "known")
                .writing("allocations", "@allocations")
                .asks("ask", "AllocationRequest", "locations", new ListValue(List.copyOf(locations)));
    }

    private static List<Value> allocations(PlanSketch plan) {
        PlanScene scene = new PlanScene(plan, 2).untilBoat("boat-1", "known");
        List<Value> options = ((ListValue) scene.variable("@allocations")).items();
        assertThat(((RealValue) ((RecordValue) options.get(0)).fields().get("totalLengthM")).value())
                .isPositive();
        return options;
    }
}
