package org.sami.ui.net;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

class GraphLayoutTest {
    private static final Plan CLV = NetScenes.plan("clv");

    private static NetDrawing drawing(Plan plan) {
        return NetLayout.given(plan, NetScenes.VOCABULARY, NetFonts::width);
    }

    @ParameterizedTest
    @EnumSource
    void equalNetsAreLaidOutEquallyAndNoVertexLiesOnAnother(GraphLayout layout) {
        Map<String, LayoutPoint> centres = layout.of(CLV, drawing(CLV), () -> false);

        assertThat(centres)
                .hasSize(CLV.places().size() + CLV.transitions().size())
                .isEqualTo(layout.of(CLV, drawing(CLV), () -> false));
        List<LayoutPoint> points = List.copyOf(centres.values());
        for (int i = 0; i < points.size(); i++) {
            for (int j = i + 1; j < points.size(); j++) {
                assertThat(Math.hypot(
                                points.get(i).x() - points.get(j).x(),
                                points.get(i).y() - points.get(j).y()))
                        .isGreaterThan(2 * NetDrawing.PLACE_RADIUS);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void whatNoEdgeConnectsLiesBesideTheRest(GraphLayout layout) {
        Mode mode = CLV.places().get(0).mode();
        List<Place> places = new ArrayList<>(CLV.places());
        places.add(new Place("alone", "alone", false, false, false, mode, List.of(), List.of(), List.of(), false));
        Plan plan = CLV.withPlaces(places);

        Map<String, LayoutPoint> centres = layout.of(plan, drawing(plan), () -> false);

        double right = CLV.places().stream()
                .mapToDouble(place -> centres.get(place.id()).x())
                .max()
                .orElseThrow();
        assertThat(centres.get("alone").x()).isGreaterThan(right + 100);
    }

    @ParameterizedTest
    @EnumSource
    void aLayoutCanBeCancelled(GraphLayout layout) {
        assertThatThrownBy(() -> layout.of(CLV, drawing(CLV), () -> true)).isInstanceOf(CancellationException.class);
    }
}
