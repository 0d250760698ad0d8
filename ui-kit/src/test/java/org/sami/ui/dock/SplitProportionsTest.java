package org.sami.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.BorderLayout;
import java.awt.Container;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import org.junit.jupiter.api.Test;
import org.sami.ui.EventThread;

class SplitProportionsTest {
    private final JSplitPane inner = EventThread.get(() -> pane(JSplitPane.VERTICAL_SPLIT, new JPanel()));
    private final JSplitPane outer = EventThread.get(() -> pane(JSplitPane.HORIZONTAL_SPLIT, inner));
    private final JPanel area = EventThread.get(() -> new JPanel(new BorderLayout()));

    @Test
    void aSmallerWindowShrinksEachSideByItsPart() {
        keepFrom(1600, 1000, 0.58, 0.7);

        resize(1280, 800);

        assertThat(part(outer)).isCloseTo(0.58, within(0.002));
        assertThat(part(inner)).isCloseTo(0.7, within(0.002));
    }

    @Test
    void manySmallStepsMoveNoDividerAside() {
        keepFrom(1600, 1000, 0.58, 0.7);

        for (int step = 1; step <= 100; step++) {
            resize(1600 - 3 * step, 1000 - 2 * step);
        }

        assertThat(part(outer)).isCloseTo(0.58, within(0.002));
        assertThat(part(inner)).isCloseTo(0.7, within(0.002));
    }

    @Test
    void aTinyWindowThatGrowsAgainIsAsItWas() {
        keepFrom(1600, 1000, 0.58, 0.7);

        resize(30, 20);
        resize(1600, 1000);

        assertThat(part(outer)).isCloseTo(0.58, within(0.002));
        assertThat(part(inner)).isCloseTo(0.7, within(0.002));
    }

    @Test
    void whereTheOperatorMovesADividerIsKeptFromThenOn() {
        keepFrom(1600, 1000, 0.58, 0.7);

        move(outer, 0.25);
        resize(1280, 800);

        assertThat(part(outer)).isCloseTo(0.25, within(0.002));
    }

    @Test
    void aPaneThatIsAddedLaterKeepsItsProportionToo() {
        EventThread.get(() -> {
            SplitProportions.keep(area);
            return area.add(outer);
        });
        resize(1600, 1000);
        move(outer, 0.8);

        resize(1280, 800);

        assertThat(part(outer)).isCloseTo(0.8, within(0.002));
    }

    private void keepFrom(int width, int height, double beside, double below) {
        EventThread.get(() -> {
            area.add(outer);
            SplitProportions.keep(area);
            return area;
        });
        resize(width, height);
        move(outer, beside);
        move(inner, below);
    }

    private static JSplitPane pane(int orientation, JComponent first) {
        JSplitPane pane = new JSplitPane(orientation, first, new JPanel());
        pane.setResizeWeight(0.5); // as Modern Docking has it
        return pane;
    }

    private void move(JSplitPane pane, double part) {
        settled(() -> {
            pane.setDividerLocation((int) Math.round(part * size(pane)));
            return pane;
        });
    }

    private void resize(int width, int height) {
        settled(() -> {
            area.setSize(width, height);
            return area;
        });
    }

    /** Does it, and lays out until the events of sizes that changed are through: outer panes first, then those in them. */
    private void settled(Supplier<Container> change) {
        EventThread.get(change);
        for (int depth = 0; depth < 4; depth++) {
            EventThread.get(() -> {
                layOut(area);
                return area;
            });
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (int at = 0; at < container.getComponentCount(); at++) {
            if (container.getComponent(at) instanceof Container child) {
                layOut(child);
            }
        }
    }

    private static double part(JSplitPane pane) {
        return EventThread.get(() -> (pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT
                        ? pane.getLeftComponent().getWidth()
                        : pane.getLeftComponent().getHeight())
                / (double) size(pane));
    }

    private static int size(JSplitPane pane) {
        return (pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT ? pane.getWidth() : pane.getHeight())
                - pane.getDividerSize();
    }
}
