package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.LayoutPoint;

class AlignmentTest {
    private static final Map<String, LayoutPoint> CENTRES = Map.of(
            "a", new LayoutPoint(0, 10),
            "b", new LayoutPoint(30, 50),
            "c", new LayoutPoint(100, 20));

    @Test
    void alignsToTheOutermostAndToTheMiddle() {
        assertThat(Alignment.LEFT.of(CENTRES)).containsEntry("c", new LayoutPoint(0, 20));
        assertThat(Alignment.RIGHT.of(CENTRES)).containsEntry("a", new LayoutPoint(100, 10));
        assertThat(Alignment.COLUMN.of(CENTRES)).containsEntry("b", new LayoutPoint(50, 50));
        assertThat(Alignment.TOP.of(CENTRES)).containsEntry("b", new LayoutPoint(30, 10));
        assertThat(Alignment.BOTTOM.of(CENTRES)).containsEntry("a", new LayoutPoint(0, 50));
        assertThat(Alignment.ROW.of(CENTRES)).containsEntry("c", new LayoutPoint(100, 30));
    }

    @Test
    void distributesBetweenTheFirstAndTheLast() {
        assertThat(Alignment.SPREAD_X.of(CENTRES))
                .containsEntry("a", new LayoutPoint(0, 10))
                .containsEntry("b", new LayoutPoint(50, 50))
                .containsEntry("c", new LayoutPoint(100, 20));
        assertThat(Alignment.SPREAD_Y.of(CENTRES)).containsEntry("c", new LayoutPoint(100, 30));
    }
}
