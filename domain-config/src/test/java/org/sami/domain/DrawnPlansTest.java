package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.drawing.TextMeasure;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;

/** The plans that ship, as they are drawn while they are edited. */
class DrawnPlansTest {
    private static final TextMeasure MEASURE = (text, style) -> 7.0 * text.length();

    static Stream<Arguments> plans() {
        return Stream.of("crw", "uav").flatMap(domain -> {
            DomainLibrary library =
                    DomainLibrary.fromClassPath("/org/sami/domain/" + domain).orThrow();
            return library.plans().stream().map(plan -> Arguments.of(plan.id(), plan, library));
        });
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("plans")
    void noLineCrossesAVertexWhereTheAuthorHasLaidThem(String id, Plan plan, DomainLibrary library) {
        assertNothingIsCrossed(edited(plan, library));
    }

    /** As the command of DREAMM does it: the layout's points are kept, its bends are not. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("plans")
    void noLineCrossesAVertexAfterALayoutInLayers(String id, Plan plan, DomainLibrary library) {
        Map<String, LayoutPoint> points = new LinkedHashMap<>();
        NetLayout.layered(plan, library.vocabulary(), MEASURE, NetDetail.AUTHOR.withRequirements(false), () -> false)
                .vertices()
                .forEach(vertex -> points.put(vertex.id(), vertex.centre()));

        assertNothingIsCrossed(NetLayout.edited(
                plan.withLayout(points), library.vocabulary(), MEASURE, NetDetail.AUTHOR, OptionalDouble.of(1)));
    }

    private static NetDrawing edited(Plan plan, DomainLibrary library) {
        return NetLayout.edited(plan, library.vocabulary(), MEASURE, NetDetail.AUTHOR, OptionalDouble.empty());
    }

    private static void assertNothingIsCrossed(NetDrawing drawing) {
        for (Edge edge : drawing.edges()) {
            for (Vertex vertex : drawing.vertices()) {
                if (!vertex.id().equals(edge.from()) && !vertex.id().equals(edge.to())) {
                    assertThat(isCrossed(vertex, edge.points()))
                            .as("%s crosses %s", edge, vertex)
                            .isFalse();
                }
            }
        }
    }

    private static boolean isCrossed(Vertex vertex, List<LayoutPoint> line) {
        for (int i = 1; i < line.size(); i++) {
            LayoutPoint from = line.get(i - 1);
            LayoutPoint to = line.get(i);
            int steps = (int) Math.ceil(Math.hypot(to.x() - from.x(), to.y() - from.y()));
            for (int step = 0; step <= steps; step++) {
                double part = steps == 0 ? 0 : (double) step / steps;
                if (covers(vertex, from.x() + part * (to.x() - from.x()), from.y() + part * (to.y() - from.y()))) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean covers(Vertex vertex, double x, double y) {
        return vertex.kind() == Kind.PLACE
                ? Math.hypot(x - vertex.centre().x(), y - vertex.centre().y()) < NetDrawing.PLACE_RADIUS
                : vertex.box().contains(x, y);
    }
}
