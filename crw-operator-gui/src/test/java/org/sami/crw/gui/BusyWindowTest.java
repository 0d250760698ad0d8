package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JRootPane;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.table.TableColumn;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Look;
import org.sami.ui.net.NetView;

/** What is in sight with 20 boats, 14 decisions and 50 messages. */
@Tag("window")
@TestInstance(Lifecycle.PER_CLASS)
class BusyWindowTest {
    private static final int LEAST_NET = 48; // a row of places with their names

    private BusySituation situation;
    private WindowInMemory shown;

    @BeforeAll
    void open(@TempDir Path folder) throws Exception {
        RealDisplay.assumed();
        situation = new BusySituation(folder, Theme.LIGHT, 100);
        shown = new WindowInMemory(situation.window());
    }

    @AfterAll
    void close() throws Exception {
        if (situation != null) {
            situation.close();
        }
    }

    private void size(int width, int height, int percent) {
        shown.look(Theme.LIGHT, percent);
        shown.size(width, height);
    }

    private <C extends Component> C find(String name, Class<C> type) {
        return Layout.find(situation.window().frame(), name, type)
                .orElseThrow(() -> new AssertionError("there is no " + name));
    }

    /** All that is looked at in a size together: this window takes seconds to get another size or scale. */
    @ParameterizedTest
    @CsvSource({"1600, 1000, 100, 4, 6", "1280, 800, 100, 4, 5", "1600, 1000, 150, 3, 3", "1280, 800, 150, 2, 2"})
    void decisionsAndBoatsAreInSightAndNothingIsScrolledWithinWhatIsScrolled(
            int width, int height, int percent, int decisions, int boats) {
        size(width, height, percent);
        decisionsThatWaitAreInSightWithMissionPlanAgeAndTimeLeft(decisions);
        eachBoatHasOneLineWithItsColumns(width, percent, boats);
        theNetOfTheMissionInFrontIsToBeSeen();
        nothingIsScrolledWithinWhatIsScrolled();
    }

    private void theNetOfTheMissionInFrontIsToBeSeen() {
        int net = WindowRobot.ask(() -> {
            front(find("missions", Container.class));
            Container root = situation.window().frame().getRootPane();
            Layout.layOut(root, root.getWidth(), root.getHeight());
            Layout.layOut(root, root.getWidth(), root.getHeight());
            return find("mission-net", NetView.class).getHeight();
        });
        assertThat(net)
                .as("height of the net")
                .isGreaterThanOrEqualTo(WindowRobot.<Integer>ask(() -> Look.px(LEAST_NET)));
    }

    private void decisionsThatWaitAreInSightWithMissionPlanAgeAndTimeLeft(int least) {
        assertThat(WindowRobot.<Integer>ask(
                        () -> find("decision-scroll", Component.class).getHeight()))
                .as("room for what is asked")
                .isGreaterThanOrEqualTo(WindowRobot.<Integer>ask(() -> Look.px(36)));
        assertThat(WindowRobot.<List<String>>ask(() -> columns("decisions-queue")))
                .containsExactly("Waits for you", "Mission", "Since", "Left");
        assertThat(WindowRobot.<Integer>ask(() -> rowsInSight("decisions-queue")))
                .isGreaterThanOrEqualTo(least);
        assertThat(WindowRobot.<Integer>ask(
                        () -> find("decisions-queue", JTable.class).getRowCount()))
                .isEqualTo(BusySituation.DECISIONS);
        assertThat(WindowRobot.<List<Object>>ask(() -> column("decisions-queue", 1)))
                .contains("Look once more · Explore Area", "Watch the links · Communications Monitoring");
    }

    @Test
    void threeInterruptsOfAMissionAreInSightWhileDecisionsWait() {
        size(1594, 970, 100); // what a window manager leaves of 1600 by 1000

        for (String name : List.of("team-avoid-boat", "battery-swap", "proxy-abort")) {
            int hidden = WindowRobot.ask(() -> {
                AbstractButton button = find("interrupt-" + name, AbstractButton.class);
                JScrollPane pane = (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, button);
                int bottom = SwingUtilities.convertPoint(
                                button,
                                0,
                                button.getHeight(),
                                pane.getViewport().getView())
                        .y;
                return bottom - pane.getViewport().getHeight();
            });
            assertThat(hidden).as("pixels of %s below the edge", name).isLessThanOrEqualTo(0);
        }
    }

    private void eachBoatHasOneLineWithItsColumns(int width, int percent, int least) {
        List<String> columns = WindowRobot.ask(() -> columns("boats-table"));
        if (percent == 100) {
            assertThat(columns).containsExactly("Boat", "What it does", "Battery", "Speed", "Path", "Link");
        } else {
            assertThat(columns).contains("Boat", "What it does", "Battery");
            assertThat(columns.contains("Link"))
                    .as("in two stacks it is left out")
                    .isEqualTo(width > 1280);
        }
        JTable boats = find("boats-table", JTable.class);
        assertThat(WindowRobot.<List<Integer>>ask(() -> IntStream.range(0, boats.getRowCount())
                        .map(boats::getRowHeight)
                        .distinct()
                        .boxed()
                        .toList()))
                .containsExactly(WindowRobot.<Integer>ask(() -> Look.px(30)));
        assertThat(WindowRobot.<Integer>ask(() -> rowsInSight("boats-table"))).isGreaterThanOrEqualTo(least);
        assertThat(WindowRobot.<Boolean>ask(
                        () -> pane(boats).getHorizontalScrollBar().isVisible()))
                .isFalse();
    }

    @Test
    void theShownDecisionIsSelectedInTheQueue() {
        new WindowRobot()
                .until(
                        "the first is selected",
                        () -> find("decisions-queue", JTable.class).getSelectedRow() == 0);
    }

    @Test
    void whatAutonomyWillDoIsSaidInWordsWithTheTimeThatIsLeft() throws Exception {
        long mission = situation.bringHome();
        WindowRobot robot = new WindowRobot();
        JTextComponent autonomy = find("decision-autonomy", JTextComponent.class);
        robot.until(
                "autonomy says what it will do",
                () -> autonomy.getText().matches("Autonomy chooses 20 boats in \\d+ s"));
        robot.until(
                "its line says how long is left",
                () -> column("decisions-queue", 3).get(0).toString().matches("\\d+ s"));
        assertThat(WindowRobot.<Object>ask(() -> column("decisions-queue", 1).get(0)))
                .isEqualTo("Squall from the north · Bring boats home");

        situation.session().abort(mission).toCompletableFuture().join();
        robot.until(
                "the others wait on",
                () -> find("decisions-queue", JTable.class).getRowCount() == BusySituation.DECISIONS);
    }

    @Test
    void boatsAreListedByTheirNumbers() {
        WindowRobot robot = new WindowRobot();
        robot.until("boats are in order", () -> column("boats-table", 0).equals(BusySituation.boats()));
    }

    @Test
    void endedMissionsHaveLeftTheTabsAndAreFoundInTheList() {
        JTabbedPane tabs = find("mission-tabs", JTabbedPane.class);
        WindowRobot robot = new WindowRobot();
        robot.until("ended ones have no tab", () -> tabs.indexOfTab("Resend to all") < 0);
        assertThat(WindowRobot.<Boolean>ask(() -> tabs.indexOfTab("Visit the buoys") > 0))
                .isTrue();
        assertThat(WindowRobot.<List<Object>>ask(() -> column("missions-over-table", 0)))
                .containsSubsequence("Connect a spare boat", "Resend to all");

        WindowRobot.ask(() -> {
            int row = column("missions-over-table", 0).indexOf("Resend to all");
            find("missions-over-table", JTable.class).setRowSelectionInterval(row, row);
            find("mission-show-ended", CommandButton.class).doClick(0);
            return null;
        });

        assertThat(WindowRobot.<String>ask(() -> tabs.getTitleAt(tabs.getSelectedIndex())))
                .isEqualTo("Resend to all");
        WindowRobot.ask(() -> {
            tabs.setSelectedIndex(0);
            return null;
        });
        robot.until("it stays as it was asked for", () -> tabs.indexOfTab("Resend to all") > 0);
    }

    private void nothingIsScrolledWithinWhatIsScrolled() {
        List<String> nested = new ArrayList<>();
        WindowRobot.ask(() -> {
            find("boats-table", JTable.class).setRowSelectionInterval(0, 0);
            return null;
        });
        JTabbedPane parts = find("boat-tabs", JTabbedPane.class);
        for (int i = 0; i < parts.getTabCount(); i++) {
            int tab = i;
            nested.addAll(WindowRobot.ask(() -> {
                front(parts);
                parts.setSelectedIndex(tab);
                return nestedAfterLayout("boat");
            }));
        }
        nested.addAll(WindowRobot.ask(() -> {
            front(find("allocation", Container.class));
            return nestedAfterLayout("allocation");
        }));

        assertThat(nested.stream().distinct()).isEmpty();
    }

    private List<String> nestedAfterLayout(String panel) {
        Container root = situation.window().frame().getRootPane();
        Layout.layOut(root, root.getWidth(), root.getHeight());
        Layout.layOut(root, root.getWidth(), root.getHeight());
        return nested(find(panel, Container.class), panel);
    }

    private static void front(Container panel) {
        for (Component at = panel; at.getParent() != null; at = at.getParent()) {
            if (at.getParent() instanceof JTabbedPane tabs) {
                tabs.setSelectedComponent(at);
            }
        }
    }

    private static List<String> nested(Container root, String where) {
        List<String> found = new ArrayList<>();
        for (JScrollPane pane : all(root, JScrollPane.class)) {
            boolean scrolls = isShown(pane) && pane.getVerticalScrollBar().isVisible();
            JScrollPane outer = (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, pane);
            if (scrolls && outer != null && outer.getVerticalScrollBar().isVisible()) {
                Component view = pane.getViewport().getView();
                found.add(where + ": " + (view == null ? pane.getName() : view.getName()) + " in " + outer.getName());
            }
        }
        return found;
    }

    private static boolean isShown(Component component) {
        for (Component at = component; at != null; at = at.getParent()) {
            if (!at.isVisible()) {
                return false;
            }
        }
        return true;
    }

    private static <C extends Component> List<C> all(Container root, Class<C> type) {
        List<C> found = new ArrayList<>();
        for (Component child : root.getComponents()) {
            if (type.isInstance(child)) {
                found.add(type.cast(child));
            }
            if (child instanceof Container inner) {
                found.addAll(all(inner, type));
            }
        }
        return found;
    }

    private static JScrollPane pane(JTable table) {
        return (JScrollPane) SwingUtilities.getAncestorOfClass(JScrollPane.class, table);
    }

    /** How many whole rows are seen of a table, in all that it lies in; the frame may be smaller than what is laid out. */
    private int rowsInSight(String name) {
        JTable table = find(name, JTable.class);
        Rectangle seen = table.getBounds();
        seen.setLocation(0, 0);
        for (Component at = table; !(at instanceof JRootPane); at = at.getParent()) {
            Rectangle parent = SwingUtilities.convertRectangle(
                    at.getParent(), new Rectangle(at.getParent().getSize()), table);
            seen = seen.intersection(parent);
        }
        Rectangle sight = seen;
        return (int) IntStream.range(0, table.getRowCount())
                .filter(row -> sight.contains(table.getCellRect(row, 0, true)))
                .count();
    }

    private List<String> columns(String name) {
        List<String> titles = new ArrayList<>();
        for (TableColumn column :
                Collections.list(find(name, JTable.class).getColumnModel().getColumns())) {
            titles.add(column.getHeaderValue().toString());
        }
        return titles;
    }

    private List<Object> column(String name, int column) {
        JTable table = find(name, JTable.class);
        return IntStream.range(0, table.getRowCount())
                .mapToObj(row -> table.getValueAt(row, column))
                .toList();
    }
}
