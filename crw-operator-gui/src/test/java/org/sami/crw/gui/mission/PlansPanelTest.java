package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.until;

import java.awt.Point;
import java.awt.Rectangle;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.TextScale;
import org.sami.spn.model.Project;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.command.CommandButton;
import org.sami.ui.window.WindowSettings;

@Isolated("the look is one for all windows of a process")
@Timeout(900)
class PlansPanelTest {
    private static final Project PROJECT = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [%s]}], 'plans': [%s]}""".formatted(each("{'plan': 'plan%1$d'}"), each("""
                            {'id': 'plan%1$d', 'name': 'Explore Area with interrupts %1$d',
                             'description': 'The operator draws an area and chooses boats; each explores its share in lanes. Team avoid boat takes all out of the way of another vessel until the operator says that it has passed; battery swap brings chosen boats to the quay and back.',
                             'places': [{'id': 'say', 'name': 'Say', 'start': true}],
                             'transitions': [], 'inEdges': [], 'outEdges': []}""")));

    private static final Project WITH_DISABLED = SessionWorld.project("""
            {'formatVersion': 1, 'id': 'lake', 'name': 'Lake', 'domain': 'crw',
             'missionTree': [{'label': 'All', 'children': [{'plan': 'whole'}, {'plan': 'tried'}]}], 'plans': [
             {'id': 'whole', 'name': 'Explore', 'places': [{'id': 'say', 'name': 'Say', 'start': true}],
              'transitions': [], 'inEdges': [], 'outEdges': []},
             {'id': 'tried', 'name': 'Explore the harbour', 'places': [{'id': 'say', 'name': 'Say', 'start': true},
               {'id': 'ask', 'name': 'Ask the harbour', 'disabled': true}],
              'transitions': [{'id': 'wait', 'name': 'Wait', 'disabled': true}], 'inEdges': [], 'outEdges': []}]}""");

    @TempDir
    private Path folder;

    private static String each(String plan) {
        return IntStream.range(0, 8).mapToObj(plan::formatted).collect(Collectors.joining(","));
    }

    /** The panel, once it lists the plans. */
    private PlansPanel panel(SessionWorld world) {
        PlansPanel plans = onEventThread(() -> new PlansPanel(
                world.context,
                new MissionStarter(
                        world.context, new WindowSettings(folder.resolve("settings")), world.editors(), values -> {})));
        JTable table = find(plans, "plans-table", JTable.class);
        until("plans are listed", () -> table.getRowCount() == 9);
        return plans;
    }

    /** The sizes are those that the panel has in windows of 1280 by 800 and 1600 by 1000. */
    @ParameterizedTest
    @CsvSource({"100, 608, 240", "150, 608, 186", "100, 660, 265", "200, 630, 420"})
    void threeWholePlansAndTheButtonThatStartsOneAreSeen(int percent, int width, int height) throws Exception {
        try (TextScale scale = TextScale.percent(percent);
                SessionWorld world = new SessionWorld(PROJECT)) {
            PlansPanel plans = panel(world);
            JTable table = find(plans, "plans-table", JTable.class);
            onEventThread(() -> {
                Layout.layOut(plans, width, height);
                Rectangle seen = ((JViewport) table.getParent()).getViewRect();
                int row = table.getRowHeight(0);
                assertThat(seen.height / row).isGreaterThanOrEqualTo(3);
                assertThat(seen.height % row).isZero();
                assertThat(seen.contains(table.getCellRect(table.getSelectedRow(), 0, true)))
                        .isTrue();
                String name = find(plans, "mission-start", CommandButton.class)
                                .getParent()
                                .isVisible()
                        ? "mission-start"
                        : "mission-start-beside";
                CommandButton start = find(plans, name, CommandButton.class);
                assertThat(start.getText()).isEqualTo("Start mission");
                assertThat(start.getWidth()).isGreaterThanOrEqualTo(start.getPreferredSize().width);
                assertThat(plans.getBounds().contains(bounds(start))).isTrue();
                return null;
            });
        }
    }

    /** What a plan does in full takes the place of rows. */
    @Test
    void rowThatIsSelectedStaysInSightWhenItsDescriptionNeedsItsPlace() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            PlansPanel plans = panel(world);
            JTable table = find(plans, "plans-table", JTable.class);
            int row = onEventThread(() -> {
                table.setRowSelectionInterval(0, 0); // the folder, which has no description
                Layout.layOut(plans, 608, 290);
                Rectangle seen = table.getVisibleRect();
                return table.rowAtPoint(new Point(5, seen.y + seen.height - 5));
            });
            onEventThread(() -> {
                table.setRowSelectionInterval(row, row);
                Layout.layOut(plans, 608, 290);
                return null;
            });
            onEventThread(() -> {
                assertThat(table.getRowCount()).isGreaterThan(row + 1);
                assertThat(table.getVisibleRect().contains(table.getCellRect(row, 0, true)))
                        .isTrue();
                return null;
            });
        }
    }

    /** The first is as low as in a replay's window of 1280 by 800. */
    @ParameterizedTest
    @CsvSource({"150, 608, 120", "150, 1000, 120", "150, 608, 150", "100, 608, 70"})
    void bothButtonsAreWholeAndLeaveRoomForPlansWhereThePanelIsLow(int percent, int width, int height)
            throws Exception {
        try (TextScale scale = TextScale.percent(percent);
                SessionWorld world = new SessionWorld(PROJECT)) {
            PlansPanel plans = panel(world);
            JTable table = find(plans, "plans-table", JTable.class);
            onEventThread(() -> {
                Layout.layOut(plans, width, height);
                for (String name : List.of("mission-start-beside", "mission-start-with-beside")) {
                    CommandButton button = find(plans, name, CommandButton.class);
                    assertThat(button.getHeight()).as(name).isGreaterThanOrEqualTo(button.getPreferredSize().height);
                    assertThat(button.getWidth()).as(name).isGreaterThanOrEqualTo(button.getPreferredSize().width);
                    assertThat(plans.getBounds().contains(bounds(button)))
                            .as(name)
                            .isTrue();
                }
                assertThat(table.getParent().getWidth()).isGreaterThanOrEqualTo(width * 2 / 5);
                return null;
            });
        }
    }

    @Test
    void plansAreFoundByWhatTheyDoAndAFolderStartsNone() throws Exception {
        try (SessionWorld world = new SessionWorld(PROJECT)) {
            PlansPanel plans = panel(world);
            assertThat(SessionWorld.rows(plans, "plans-table")).startsWith("All|\nExplore Area with interrupts 0|The");
            assertThat(world.whyNot("mission-start")).isEmpty();

            SessionWorld.select(plans, "plans-table", 0);
            assertThat(world.whyNot("mission-start")).isEqualTo("select a plan in All first");

            SessionWorld.type(plans, "plans-search", "quay 5");
            assertThat(SessionWorld.rows(plans, "plans-table").lines())
                    .hasSize(2)
                    .element(1)
                    .asString()
                    .startsWith("Explore Area with interrupts 5");
            assertThat(world.whyNot("mission-start")).isEmpty();

            SessionWorld.type(plans, "plans-search", "submarine");
            assertThat(SessionWorld.rows(plans, "plans-table")).isEmpty();
            assertThat(world.whyNot("mission-start")).isEqualTo("select a plan first");

            SessionWorld.type(plans, "plans-search", "");
            assertThat(SessionWorld.rows(plans, "plans-table").lines()).hasSize(9);
        }
    }

    @ParameterizedTest
    @CsvSource({"100, 660, 265", "150, 608, 186"})
    void whatIsDisabledForTryingIsSaidBeforeAMissionStarts(int percent, int width, int height) throws Exception {
        try (TextScale scale = TextScale.percent(percent);
                SessionWorld world = new SessionWorld(WITH_DISABLED)) {
            PlansPanel plans = onEventThread(() -> new PlansPanel(
                    world.context,
                    new MissionStarter(
                            world.context,
                            new WindowSettings(folder.resolve("settings")),
                            world.editors(),
                            values -> {})));
            JTable table = find(plans, "plans-table", JTable.class);
            until("plans are listed", () -> table.getRowCount() == 3);
            JLabel note = find(plans, "plans-disabled", JLabel.class);
            int before = onEventThread(() -> {
                table.setRowSelectionInterval(1, 1);
                Layout.layOut(plans, width, height);
                assertThat(note.getText()).isBlank();
                return table.getParent().getHeight();
            });

            onEventThread(() -> {
                table.setRowSelectionInterval(2, 2);
                Layout.layOut(plans, width, height);
                assertThat(note.getText()).isEqualTo("△ Also does what is disabled for trying: Ask the harbour, Wait");
                assertThat(note.getToolTipText()).contains("Ask the harbour, Wait");
                assertThat(new Rectangle(plans.getSize()).contains(note.getBounds()))
                        .isTrue();
                if (percent == 100) {
                    assertThat(TextFit.faults(note)).isEmpty();
                }
                assertThat(table.getParent().getHeight())
                        .as("nothing moves as another plan is selected")
                        .isEqualTo(before);
                return null;
            });
        }
    }

    private static Rectangle bounds(CommandButton button) {
        return SwingUtilities.convertRectangle(
                button.getParent(), button.getBounds(), button.getParent().getParent());
    }
}
