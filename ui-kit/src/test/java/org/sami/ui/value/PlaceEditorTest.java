package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ValueType;
import org.sami.ui.check.Layout;
import org.sami.ui.geo.GeoSketch;
import org.sami.ui.map.MapView;

class PlaceEditorTest {
    private final ValueEditor area = SampleDomain.EDITORS.editor(ValueField.of("area", ValueType.Simple.AREA));

    @Test
    void aWidePanelHasTheTextBesideTheMapAndCutsNothingOfIt() {
        JComponent panel = laidOut(620);

        assertThat(left(text(), panel)).isGreaterThan(left(map(), panel) + map().getWidth() - 1);
        Container entry = SwingUtilities.getAncestorOfClass(JScrollPane.class, text());
        assertThat(left(entry, panel) + entry.getWidth()).isBetween(600, 620);
    }

    @Test
    void aNarrowPanelHasItBelow() {
        JComponent panel = laidOut(400);

        assertThat(SwingUtilities.convertPoint(text(), 0, 0, panel).y).isGreaterThan(map().getHeight() - 1);
    }

    @Test
    void textThatIsEmptiedTakesTheDrawingAway() {
        laidOut(620);
        text().setText("45.1, 10.1\n45.1, 10.2\n45.2, 10.2");

        text().setText("");
        click(map().canvas(), 40, 30);

        assertThat(text().getText().lines()).hasSize(1);
    }

    @Test
    void whatIsDrawnOnAnotherMapIsSeenOnThisOne() {
        laidOut(620);
        GeoSketch sketch = area.sketch().orElseThrow();
        List<GeoPoint> far = List.of(GeoPoint.of(25.36, 51.53), GeoPoint.of(25.36, 51.54), GeoPoint.of(25.35, 51.54));

        far.forEach(sketch::add);

        assertThat(far).allMatch(point -> map().frame().isShown(point));
        assertThat(map().frame()
                        .distancePx(
                                far.get(0),
                                map().frame().px(far.get(1)),
                                map().frame().py(far.get(1))))
                .as("pixels of the first line")
                .isGreaterThan(40);
    }

    @Test
    void theWheelScrollsTheFormWhereItCanBeScrolledAndElseZooms() {
        JScrollPane form = new JScrollPane(area.component());
        Layout.layOut(form, 620, 100);
        double before = map().frame().worldPx();

        turnWheel(0);
        assertThat(form.getViewport().getViewPosition().y).isPositive();
        assertThat(map().frame().worldPx()).isEqualTo(before);

        turnWheel(InputEvent.CTRL_DOWN_MASK);
        assertThat(map().frame().worldPx()).as("with Ctrl held").isNotEqualTo(before);

        Layout.layOut(form, 620, 600);
        double shown = map().frame().worldPx();
        turnWheel(0);
        assertThat(map().frame().worldPx()).as("all of the form is in sight").isNotEqualTo(shown);
    }

    private void turnWheel(int modifiers) {
        JComponent canvas = map().canvas();
        canvas.dispatchEvent(new MouseWheelEvent(
                canvas,
                MouseEvent.MOUSE_WHEEL,
                0,
                modifiers,
                40,
                30,
                0,
                false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL,
                3,
                1));
    }

    private static void click(JComponent canvas, int x, int y) {
        for (int what : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
            canvas.dispatchEvent(new MouseEvent(canvas, what, 0, 0, x, y, 1, false, MouseEvent.BUTTON1));
        }
    }

    private JComponent laidOut(int width) {
        Layout.layOut(area.component(), width, 200);
        return area.component();
    }

    private JTextArea text() {
        return Layout.find(area.component(), "value-area-text", JTextArea.class).orElseThrow();
    }

    private MapView map() {
        return Layout.find(area.component(), "value-area-map", MapView.class).orElseThrow();
    }

    private static int left(Container component, JComponent in) {
        return SwingUtilities.convertPoint(component, 0, 0, in).x;
    }
}
