package org.sami.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.BorderLayout;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Point;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.sami.ui.EventThread;

class SplitProportionsTest {
    private final JSplitPane inner = EventThread.get(() -> pane(JSplitPane.VERTICAL_SPLIT, new JPanel()));
    private final JSplitPane outer = EventThread.get(() -> pane(JSplitPane.HORIZONTAL_SPLIT, inner));
    private SplitProportions proportions;
    private int moves;
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

    /** A layout may come and go with a size before anybody hears of it, and put the divider somewhere meanwhile. */
    @Test
    void aDividerThatALayoutMovesInPassingIsNoneThatSomebodyMoved() {
        keepFrom(1600, 1000, 0.58, 0.7);
        int byHand = moves;

        settled(() -> {
            Dimension whole = inner.getSize();
            inner.setSize(whole.width, 300);
            inner.setDividerLocation(90);
            inner.setSize(whole);
            inner.setDividerLocation(300);
            return area;
        });

        assertThat(part(inner)).isCloseTo(0.7, within(0.002));
        assertThat(moves).as("times that somebody moved a divider").isEqualTo(byHand);
    }

    @Test
    void aPaneThatIsAddedLaterKeepsItsProportionToo() {
        EventThread.get(() -> {
            proportions = SplitProportions.keep(area, () -> moves++);
            return area.add(outer);
        });
        resize(1600, 1000);
        move(outer, 0.8);

        resize(1280, 800);

        assertThat(part(outer)).isCloseTo(0.8, within(0.002));
    }

    @Test
    void aSideWhosePanelsAreAllEmptyLeavesItsRoomUntilSomethingComes() {
        DockPanel decisions = panels();
        keepFrom(1600, 1000, 0.58, 0.7);

        empty(decisions, true);
        assertThat(below(inner)).isCloseTo(120, within(2));
        resize(1280, 800);
        assertThat(below(inner)).as("in a smaller window as well").isCloseTo(120, within(2));

        empty(decisions, false);
        assertThat(part(inner)).isCloseTo(0.7, within(0.002));
        assertThat(part(outer)).isCloseTo(0.58, within(0.002));
        assertThat(moves).as("times that somebody moved a divider").isEqualTo(2); // by keepFrom
    }

    @Test
    void nothingMovesBeforeItMay() {
        DockPanel decisions = panels();
        keepFrom(1600, 1000, 0.58, 0.7);

        settled(() -> {
            decisions.setEmpty(true);
            proportions.share(pane -> false, pane -> true, pane -> Optional.empty());
            return area;
        });
        assertThat(part(inner)).isCloseTo(0.7, within(0.002));

        empty(decisions, true);
        settled(() -> {
            decisions.setEmpty(false);
            proportions.share(pane -> true, pane -> false, pane -> Optional.empty());
            return area;
        });
        assertThat(below(inner)).isCloseTo(120, within(2));
    }

    @Test
    void theProportionIsKnownWhileASideLeavesItsRoom() {
        DockPanel decisions = panels();
        keepFrom(1600, 1000, 0.58, 0.7);
        empty(decisions, true);
        double[] seen = new double[1];

        EventThread.get(() -> {
            proportions.inProportion(() -> seen[0] = inner.getDividerLocation() / (double) size(inner));
            return area;
        });

        assertThat(seen[0]).isCloseTo(0.7, within(0.002));
        assertThat(below(inner)).isCloseTo(120, within(2));
    }

    @Test
    void anEmptySideThatTheOperatorMakesLargerStaysSo() {
        DockPanel decisions = panels();
        keepFrom(1600, 1000, 0.58, 0.7);
        empty(decisions, true);

        move(inner, 0.5);
        empty(decisions, true);

        assertThat(part(inner)).isCloseTo(0.5, within(0.002));
    }

    @Test
    void anArrangementThatIsRestoredLateIsSharedAnew() {
        DockPanel decisions = panels();
        keepFrom(1600, 1000, 0.58, 0.7);
        empty(decisions, true);

        move(inner, 0.7); // as Modern Docking does
        empty(decisions, true);

        assertThat(below(inner)).isCloseTo(120, within(2));
    }

    @Test
    void twoEmptySidesKeepTheirProportion() {
        DockPanel decisions = panels();
        keepFrom(1600, 1000, 0.58, 0.7);

        EventThread.get(() -> {
            ((DockPanel) inner.getLeftComponent()).setEmpty(true);
            return area;
        });
        empty(decisions, true);

        assertThat(part(inner)).isCloseTo(0.7, within(0.002));
    }

    @Test
    void emptyPanelsBelowOneAnotherHaveEachItsLine() {
        JSplitPane lowest = EventThread.get(() -> {
            JSplitPane pane = new JSplitPane(
                    JSplitPane.VERTICAL_SPLIT,
                    new DockPanel("decisions", "Decisions", "decision", new JPanel()),
                    new DockPanel("messages", "Messages", "message", new JPanel()));
            inner.setLeftComponent(new DockPanel("map", "Map", "map", new JPanel()));
            inner.setRightComponent(pane);
            return pane;
        });
        keepFrom(1600, 1000, 0.58, 0.3);
        move(lowest, 0.8);

        EventThread.get(() -> {
            ((DockPanel) lowest.getLeftComponent()).setEmpty(true);
            return area;
        });
        empty((DockPanel) lowest.getRightComponent(), true);

        assertThat(below(lowest)).isCloseTo(120, within(3));
        assertThat(EventThread.get(() -> lowest.getLeftComponent().getHeight())).isCloseTo(120, within(3));
    }

    @Test
    void whatAnEmptySideLeavesGoesToThePanelThatUsesRoomAndNotToItsNeighbour() {
        JSplitPane lowest = missionsDecisionsMessages();

        empty((DockPanel) lowest.getLeftComponent(), true);

        int natural = (int) Math.round(0.6 * 1000 * 0.3);
        assertThat(below(lowest)).as("the messages").isCloseTo(natural, within(12));
        assertThat(above(lowest)).as("the decisions").isCloseTo(120, within(2));
        assertThat(above(inner)).as("the missions").isCloseTo(1000 - natural - 120, within(24));

        resize(1280, 800);
        assertThat(above(lowest)).as("in a smaller window as well").isCloseTo(120, within(2));
        assertThat(below(lowest)).isCloseTo((int) Math.round(0.6 * 800 * 0.3), within(12));

        empty((DockPanel) lowest.getLeftComponent(), false);
        assertThat(part(inner)).isCloseTo(0.4, within(0.002));
        assertThat(part(lowest)).isCloseTo(0.7, within(0.004));
    }

    @Test
    void aDividerThatSomebodyMovesWhileASideIsEmptyStaysThereUntilSomethingComesOrGoes() {
        JSplitPane lowest = missionsDecisionsMessages();
        DockPanel decisions = (DockPanel) lowest.getLeftComponent();
        empty(decisions, true);

        move(inner, 0.5);
        empty(decisions, true);
        assertThat(part(inner)).isCloseTo(0.5, within(0.002));
        assertThat(above(lowest)).as("the decisions").isCloseTo(120, within(2));

        empty(decisions, false);
        assertThat(part(inner)).isCloseTo(0.5, within(0.002));
        assertThat(part(lowest)).isCloseTo(0.7, within(0.004));
    }

    @Test
    void sidesThatComeBackOneAfterTheOtherHaveTheRoomThatTheyHad() {
        JSplitPane lowest = missionsDecisionsMessages();
        DockPanel decisions = (DockPanel) lowest.getLeftComponent();
        DockPanel messages = (DockPanel) lowest.getRightComponent();
        EventThread.get(() -> {
            decisions.setEmpty(true);
            return area;
        });
        empty(messages, true);
        assertThat(above(inner)).as("the missions").isGreaterThan(700);

        for (DockPanel panel : List.of(messages, decisions)) {
            settled(() -> {
                panel.setEmpty(false);
                proportions.share(pane -> true, pane -> true, pane -> Optional.empty());
                lowest.doLayout(); // a split pane is laid out by itself, maybe before the one around it
                return area;
            });
        }

        assertThat(part(inner)).isCloseTo(0.4, within(0.002));
        assertThat(part(lowest)).isCloseTo(0.7, within(0.004));
        assertThat(moves).as("times that somebody moved a divider").isEqualTo(3); // by the test
    }

    @Test
    void nothingOfTheColumnMovesBeforeAllOfItMay() {
        JSplitPane lowest = missionsDecisionsMessages();
        List<JSplitPane> asked = new ArrayList<>();

        settled(() -> {
            ((DockPanel) lowest.getLeftComponent()).setEmpty(true);
            proportions.share(pane -> !asked.add(pane), pane -> true, pane -> Optional.empty());
            return area;
        });

        assertThat(asked).as("the pane with all that would move").containsExactly(inner);
        assertThat(part(inner)).isCloseTo(0.4, within(0.002));
        assertThat(part(lowest)).isCloseTo(0.7, within(0.004));
    }

    @Test
    void aButtonUnderARestingPointerDoesNotMoveAway() {
        JSplitPane lowest = missionsDecisionsMessages();
        JButton confirm = button((DockPanel) inner.getLeftComponent(), BorderLayout.SOUTH);

        shareWithPointerOn(confirm, (DockPanel) lowest.getLeftComponent());

        assertThat(part(inner)).isCloseTo(0.4, within(0.002));
        assertThat(part(lowest)).isCloseTo(0.7, within(0.004));
        empty((DockPanel) lowest.getLeftComponent(), true);
        assertThat(above(lowest)).as("once it is left").isCloseTo(120, within(2));
    }

    @Test
    void aRestingPointerOnAButtonThatStaysWhereItIsHoldsNothingUp() {
        JSplitPane lowest = missionsDecisionsMessages();
        JButton abort = button((DockPanel) inner.getLeftComponent(), BorderLayout.NORTH);

        shareWithPointerOn(abort, (DockPanel) lowest.getLeftComponent());

        assertThat(above(lowest)).as("the decisions").isCloseTo(120, within(2));
    }

    private JButton button(DockPanel panel, String where) {
        JButton button = new JButton("press");
        settled(() -> {
            panel.content().setLayout(new BorderLayout());
            panel.content().add(button, where);
            return area;
        });
        return button;
    }

    private void shareWithPointerOn(JButton button, DockPanel gone) {
        settled(() -> {
            area.addNotify(); // what is in no window is validated too
            gone.setEmpty(true);
            Point at = SwingUtilities.convertPoint(button, 5, 5, inner);
            PointerRest pointer = new PointerRest(() -> 0, pane -> Optional.of(at));
            proportions.share(pane -> true, pane -> true, pointer::pressable);
            return area;
        });
    }

    /** The column of the operator's window: missions at 40 %, below them decisions at 70 % of the rest, and messages. */
    private JSplitPane missionsDecisionsMessages() {
        JSplitPane lowest = EventThread.get(() -> {
            JSplitPane pane = new JSplitPane(
                    JSplitPane.VERTICAL_SPLIT,
                    new DockPanel("decisions", "Decisions", "decision", new JPanel()),
                    new DockPanel("messages", "Messages", "message", new JPanel()));
            inner.setLeftComponent(new DockPanel("missions", "Missions", "net", new JPanel()).withUseOfRoom());
            inner.setRightComponent(pane);
            return pane;
        });
        keepFrom(1600, 1000, 0.58, 0.4);
        move(lowest, 0.7);
        return lowest;
    }

    /** Puts the map above and the decisions below into the inner pane; gives the latter. */
    private DockPanel panels() {
        return EventThread.get(() -> {
            inner.setLeftComponent(new DockPanel("map", "Map", "map", new JPanel()));
            DockPanel decisions = new DockPanel("decisions", "Decisions", "decision", new JPanel());
            inner.setRightComponent(decisions);
            return decisions;
        });
    }

    private void empty(DockPanel panel, boolean empty) {
        settled(() -> {
            panel.setEmpty(empty);
            proportions.share(pane -> true, pane -> true, pane -> Optional.empty());
            return area;
        });
    }

    private static int below(JSplitPane pane) {
        return EventThread.get(() -> pane.getRightComponent().getHeight());
    }

    private static int above(JSplitPane pane) {
        return EventThread.get(() -> pane.getLeftComponent().getHeight());
    }

    private void keepFrom(int width, int height, double beside, double below) {
        EventThread.get(() -> {
            area.add(outer);
            proportions = SplitProportions.keep(area, () -> moves++);
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
