package org.sami.ui.geo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;

class GeoSketchTest {
    private static final GeoPoint A = GeoPoint.of(45.70, 10.72);
    private static final GeoPoint B = GeoPoint.of(45.70, 10.73);
    private static final GeoPoint C = GeoPoint.of(45.71, 10.73);
    private static final GeoPoint D = GeoPoint.of(45.71, 10.72);

    @Test
    void pointTakesThePlaceOfTheEarlierOne() {
        GeoSketch sketch = new GeoSketch(GeoShape.POINT);
        assertThat(sketch.problem()).contains("Click 1 point on the map");

        sketch.add(A);
        sketch.add(B);

        assertThat(sketch.value()).contains(B);
    }

    @Test
    void eachShapeBecomesItsValue() {
        assertThat(drawn(GeoShape.POINTS, A).value()).contains(new ListValue(List.of(A)));
        assertThat(drawn(GeoShape.PATH, A, B).value()).contains(new GeoPath(List.of(A, B)));
        assertThat(drawn(GeoShape.AREA, A, B, C).value()).contains(new GeoArea(List.of(A, B, C), List.of()));
    }

    @Test
    void saysHowManyPointsAreMissing() {
        GeoSketch sketch = drawn(GeoShape.AREA, A);

        assertThat(sketch.value()).isEmpty();
        assertThat(sketch.problem()).contains("Click 2 more points on the map");
    }

    @Test
    void saysWhereAnOutlineCrossesItself() {
        GeoSketch sketch = drawn(GeoShape.AREA, A, C, B, D);

        assertThat(sketch.value()).isEmpty();
        assertThat(sketch.problem().orElseThrow()).contains("crosses itself between points 1 and 3");
    }

    @Test
    void undoesAndRedoesEachChange() {
        GeoSketch sketch = drawn(GeoShape.PATH, A, B);
        sketch.move(0, C);
        sketch.remove(1);
        sketch.clear();

        sketch.undo();
        assertThat(sketch.points()).containsExactly(C);
        sketch.undo();
        assertThat(sketch.points()).containsExactly(C, B);
        sketch.undo();
        assertThat(sketch.points()).containsExactly(A, B);
        sketch.redo();
        assertThat(sketch.points()).containsExactly(C, B);
        sketch.add(D);
        assertThat(sketch.canRedo()).isFalse();
    }

    @Test
    void undoesADragAsOneChange() {
        GeoSketch sketch = drawn(GeoShape.PATH, A, B);
        sketch.beginMove();
        sketch.move(1, C);
        sketch.move(1, D);
        sketch.endMove();

        sketch.undo();

        assertThat(sketch.points()).containsExactly(A, B);
    }

    @Test
    void aPressThatMovesNothingIsNoChange() {
        GeoSketch sketch = drawn(GeoShape.POINT, A);
        sketch.beginMove();
        sketch.endMove();

        sketch.undo();

        assertThat(sketch.points()).isEmpty();
        assertThat(sketch.canUndo()).isFalse();
    }

    @Test
    void keepsTheHolesOfTheAreaThatIsShown() {
        GeoArea area = new GeoArea(List.of(A, B, C, D), List.of(List.of(A, B, C)));
        GeoSketch sketch = new GeoSketch(GeoShape.AREA);

        sketch.show(area);

        assertThat(sketch.value()).contains(area);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sketch.show(A))
                .withMessageContaining("A area is drawn here".substring(2));
    }

    @Test
    void tellsListenersOfEachChange() {
        AtomicInteger told = new AtomicInteger();
        GeoSketch sketch = new GeoSketch(GeoShape.PATH);
        sketch.addListener(told::incrementAndGet);

        sketch.add(A);
        sketch.select(-1);
        sketch.undo();

        assertThat(told).hasValue(3);
    }

    private static GeoSketch drawn(GeoShape shape, GeoPoint... points) {
        GeoSketch sketch = new GeoSketch(shape);
        List.of(points).forEach(sketch::add);
        return sketch;
    }
}
