package org.sami.dreamm.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.LayoutPoint;

class SnapWhileDraggingTest {
    private static final LayoutPoint FROM = new LayoutPoint(13, 7);

    @Test
    void liesInLineWithANeighbourThatIsNear() {
        SnapWhileDragging guide =
                SnapWhileDragging.of(FROM, 100, 50, List.of(new LayoutPoint(117, 300), new LayoutPoint(110, 0)));

        assertThat(FROM.x() + guide.dx()).isEqualTo(110); // nearer to 113 than 117
        assertThat(guide.column()).contains(110.0);
        assertThat(guide.row()).isEmpty();
    }

    @Test
    void liesOnTheGridWhereNoNeighbourIsNear() {
        SnapWhileDragging guide = SnapWhileDragging.of(FROM, 100, 50, List.of(new LayoutPoint(500, 500)));

        assertThat(FROM.x() + guide.dx()).isEqualTo(120);
        assertThat(FROM.y() + guide.dy()).isEqualTo(60);
    }
}
