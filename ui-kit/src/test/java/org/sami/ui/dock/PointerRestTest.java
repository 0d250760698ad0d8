package org.sami.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTable;
import javax.swing.plaf.basic.BasicSplitPaneDivider;
import org.junit.jupiter.api.Test;
import org.sami.ui.EventThread;

class PointerRestTest {
    private static final Point OVER_TEXT = new Point(150, 10);
    private static final Point OVER_BUTTON = new Point(50, 10);
    private static final Point OVER_ROW = new Point(50, 50);
    private static final Point BELOW_ROWS = new Point(50, 110);

    private final JLabel text = new JLabel("Nothing waits for you.");
    private final JButton button = new JButton("Answer");
    private final JTable table = new JTable(2, 1);
    private final JPanel column = EventThread.get(() -> {
        JPanel panel = new JPanel(null);
        button.setBounds(0, 0, 100, 40);
        text.setBounds(100, 0, 100, 40);
        table.setBounds(0, 40, 100, 80);
        table.setRowHeight(20);
        List.of(button, text, table).forEach(panel::add);
        panel.setSize(200, 120);
        return panel;
    });
    private long nanos = 1;
    private Optional<Point> at = Optional.empty();
    private final PointerRest pointer = new PointerRest(() -> nanos, container -> at);

    @Test
    void aColumnShrinksOnceThePointerHasRestedForFiveSecondsOverIt() {
        event(MouseEvent.MOUSE_MOVED, OVER_TEXT);

        assertThat(pointer.letsShrink(column)).as("as it stops").isFalse();
        pass(4900);
        assertThat(pointer.letsShrink(column)).as("after 4.9 s").isFalse();
        pass(200);
        assertThat(pointer.letsShrink(column)).as("after 5.1 s").isTrue();
    }

    @Test
    void aMoveBeginsTheRestAnew() {
        event(MouseEvent.MOUSE_MOVED, OVER_TEXT);
        pass(4900);
        event(MouseEvent.MOUSE_MOVED, OVER_TEXT);
        pass(4900);

        assertThat(pointer.letsShrink(column)).isFalse();
    }

    @Test
    void nothingMovesWhileAButtonIsDownHoweverLong() {
        event(MouseEvent.MOUSE_PRESSED, OVER_TEXT);
        pass(60_000);
        assertThat(pointer.letsShrink(column)).as("while it is down").isFalse();
        assertThat(pointer.letsReturn(column)).as("while it is down").isFalse();

        event(MouseEvent.MOUSE_RELEASED, OVER_TEXT);
        assertThat(pointer.letsShrink(column)).as("as it is released").isFalse();
        pass(5100);
        assertThat(pointer.letsShrink(column)).isTrue();
    }

    @Test
    void aColumnShrinksAtOnceWhereThePointerIsElsewhereOrWasNeverUsed() {
        at = Optional.of(OVER_TEXT);
        assertThat(pointer.letsShrink(column)).as("never used").isTrue();

        event(MouseEvent.MOUSE_MOVED, OVER_TEXT);
        at = Optional.empty();
        assertThat(pointer.letsShrink(column)).as("elsewhere").isTrue();
    }

    @Test
    void whatComesBackWaitsForASecondOfRestOnly() {
        event(MouseEvent.MOUSE_MOVED, OVER_TEXT);
        pass(900);
        assertThat(pointer.letsReturn(column)).isFalse();
        pass(200);
        assertThat(pointer.letsReturn(column)).isTrue();
    }

    @Test
    void whatCanBePressedUnderThePointerIsToStay() {
        assertThat(pointedAt(OVER_BUTTON)).contains(button);
        assertThat(pointedAt(OVER_ROW)).contains(table);
        assertThat(pointedAt(OVER_TEXT)).as("text").isEmpty();
        assertThat(pointedAt(BELOW_ROWS)).as("below the rows of a table").isEmpty();
        at = Optional.empty();
        assertThat(pointer.pressable(column)).as("elsewhere").isEmpty();
    }

    @Test
    void whatOnlyHasATooltipCannotBePressed() {
        EventThread.get(() -> {
            text.setToolTipText("when a mission asks, the question appears here");
            return text;
        });

        assertThat(pointedAt(OVER_TEXT)).isEmpty();
    }

    @Test
    void aDividerCanBePressedAndWhatLiesBesideItCannot() {
        EventThread.get(() -> {
            JSplitPane pane = new JSplitPane(JSplitPane.VERTICAL_SPLIT, new JLabel("above"), new JLabel("below"));
            pane.setBounds(100, 0, 100, 100);
            pane.setDividerLocation(50);
            column.remove(text);
            column.add(pane);
            pane.doLayout();
            return pane;
        });

        assertThat(pointedAt(OVER_TEXT)).as("above").isEmpty();
        assertThat(pointedAt(new Point(150, 52)))
                .as("the divider")
                .hasValueSatisfying(what -> assertThat(what).isInstanceOf(BasicSplitPaneDivider.class));
    }

    @Test
    void aButtonThatHasMovedIsAnotherPlaceToPress() {
        at = Optional.of(OVER_BUTTON);
        Optional<PointerRest.Pressable> before = pointer.pressable(column);

        EventThread.get(() -> {
            button.setLocation(5, 0);
            return button;
        });

        assertThat(before).isPresent();
        assertThat(pointer.pressable(column)).isNotEqualTo(before);
    }

    private Optional<Component> pointedAt(Point point) {
        at = Optional.of(point);
        return pointer.pressable(column).map(PointerRest.Pressable::what);
    }

    private void pass(long millis) {
        nanos += TimeUnit.MILLISECONDS.toNanos(millis);
    }

    private void event(int id, Point point) {
        at = Optional.of(point);
        boolean pressed = id == MouseEvent.MOUSE_PRESSED;
        pointer.eventDispatched(new MouseEvent(
                column,
                id,
                0,
                pressed ? InputEvent.BUTTON1_DOWN_MASK : 0,
                point.x,
                point.y,
                1,
                false,
                pressed ? MouseEvent.BUTTON1 : MouseEvent.NOBUTTON));
    }
}
