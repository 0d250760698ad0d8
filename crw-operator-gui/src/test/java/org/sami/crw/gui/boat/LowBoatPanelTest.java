package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;

import java.awt.Rectangle;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.TextScale;
import org.sami.crw.proxy.command.Stop;
import org.sami.spn.protocol.Priority;
import org.sami.ui.check.Layout;
import org.sami.ui.command.CommandButton;

/** The panel of a boat as low as it is in a window of 1280 by 800 at 150 %. */
@Isolated("the look is one for all windows of a process")
@Timeout(900)
class LowBoatPanelTest {
    private static final int WIDTH = 604;
    private static final int HEIGHT = 272;

    @Test
    void aWholeCommandAndWhatIsDoneWithItAreSeen() throws Exception {
        try (TextScale large = TextScale.percent(150);
                SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world);
            SessionWorld.get(world.session.fleet().ask(boats -> {
                boats.find("anna").orElseThrow().commands().submit(new Stop("keep", 7, 7, Priority.LOW, true));
                return null;
            }));
            JTable queue = find(panel, "boat-queue", JTable.class);
            SessionWorld.until("it has a command", () -> {
                panel.refresh();
                return queue.getRowCount() > 0;
            });

            onEventThread(() -> {
                Layout.layOut(panel, WIDTH, HEIGHT);
                Rectangle row = queue.getCellRect(0, 0, true);
                assertThat(queue.getVisibleRect().contains(0, row.y, 1, row.height))
                        .isTrue();
                assertWhole(find(panel, "boat-cancel-command", CommandButton.class));
                return null;
            });
        }
    }

    @Test
    void theStickThatDrivesItIsWhole() throws Exception {
        try (TextScale large = TextScale.percent(150);
                SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            SelectedBoatPanel panel = panel(world);
            onEventThread(() -> {
                JTabbedPane tabs = find(panel, "boat-tabs", JTabbedPane.class);
                tabs.setSelectedIndex(tabs.indexOfTab("By hand"));
                Layout.layOut(panel, WIDTH, HEIGHT);
                assertWhole(find(panel, "boat-stick", StickView.class));
                return null;
            });
        }
    }

    private static void assertWhole(JComponent part) {
        assertThat(part.getHeight()).isPositive();
        assertThat(part.getVisibleRect()).isEqualTo(new Rectangle(part.getSize()));
    }

    private static SelectedBoatPanel panel(SessionWorld world) {
        return onEventThread(() -> {
            SelectedBoatPanel panel = new SelectedBoatPanel(world.context);
            world.context.boats().select(List.of("anna"));
            Layout.layOut(panel, WIDTH, HEIGHT);
            return panel;
        });
    }
}
