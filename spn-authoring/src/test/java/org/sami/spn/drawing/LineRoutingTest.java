package org.sami.spn.drawing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;

class LineRoutingTest {
    private final Vertex left = vertex("left", Kind.PLACE, 0, 0);
    private final Vertex middle = vertex("middle", Kind.PLACE, 150, 0);
    private final Vertex right = vertex("right", Kind.TRANSITION, 300, 0);
    private final Vertex other = vertex("other", Kind.TRANSITION, 0, 0);

    private static Vertex vertex(String id, Kind kind, double x, double y) {
        return new Vertex(id, kind, new LayoutPoint(x, y), false, false, false, false, false);
    }

    private static void assertClear(List<LayoutPoint> line, Vertex... vertices) {
        for (Vertex vertex : vertices) {
            for (int i = 1; i < line.size(); i++) {
                assertThat(LineRouting.isMet(vertex, line.get(i - 1), line.get(i)))
                        .as("%s on %s", vertex.id(), line)
                        .isFalse();
            }
        }
    }

    @Test
    void lineThatMeetsNothingStaysStraight() {
        LineRouting lines = new LineRouting(List.of(left, middle, right));

        assertThat(lines.line(left, middle, false)).isEqualTo(NetShapes.line(left, middle, false));
    }

    @Test
    void lineLeadsAroundAVertexInItsWay() {
        List<LayoutPoint> line = new LineRouting(List.of(left, middle, right)).line(left, right, false);

        assertThat(line).hasSizeBetween(3, 4);
        assertClear(line, middle);
    }

    @Test
    void lineLeadsAroundAWallOfVertices() {
        Vertex above = vertex("above", Kind.PLACE, 150, -50);
        Vertex below = vertex("below", Kind.PLACE, 150, 50);

        List<LayoutPoint> line = new LineRouting(List.of(left, middle, above, below, right)).line(left, right, false);

        assertClear(line, middle, above, below);
    }

    /** Two edges that join the same row are distinguished where they bend. */
    @Test
    void linesAroundTheSameVertexHaveBendsOfTheirOwn() {
        LineRouting lines = new LineRouting(List.of(left, middle, right));

        List<LayoutPoint> there = lines.line(left, right, true);
        List<LayoutPoint> back = lines.line(right, left, true);

        assertThat(there.subList(1, there.size() - 1)).doesNotContainAnyElementsOf(back.subList(1, back.size() - 1));
        assertClear(there, middle);
        assertClear(back, middle);
    }

    @Test
    void lineStaysStraightWhereThereIsNoWay() {
        LineRouting lines = new LineRouting(List.of(left, other, right));

        assertThat(lines.line(left, right, false)).isEqualTo(NetShapes.line(left, right, false));
    }
}
