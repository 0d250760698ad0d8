package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.get;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.rows;
import static org.sami.crw.gui.SessionWorld.select;
import static org.sami.crw.gui.SessionWorld.until;

import java.awt.Rectangle;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import javax.swing.JTable;
import javax.swing.JViewport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.TextScale;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

@Isolated("the look is one for all windows of a process")
@Timeout(900)
class BoatListPanelTest {
    @TempDir
    private Path folder;

    @Test
    void aBoatThatIsGoneIsSelectedNoLonger() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna", "bert")) {
            laidOut(() -> panel(world));
            onEventThread(() -> {
                world.context.boats().select(List.of("anna", "bert"));
                return null;
            });

            get(world.session.fleet().disconnect("anna"));

            until(
                    "anna is gone",
                    () -> world.context.models().fleet().boat("anna").isEmpty());
            assertThat(onEventThread(() -> world.context.boats().boats())).containsExactly("bert");
        }
    }

    @Test
    void aBoatThatNeverAnsweredHasARowAndItsAddressCanBeGivenUp() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna");
                ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            BoatAddress nobody = new BoatAddress("127.0.0.1", taken.getLocalPort());
            taken.close();
            BoatListPanel panel = laidOut(() -> panel(world));
            world.session.fleet().connect(nobody);

            shows(panel, nobody + "|△ " + nobody + " · no answer · connection refused · tried ");
            assertThat(rows(panel, "boats-table")).contains("|none yet");
            select(panel, "boats-table", 0); // worst first
            assertThat(onEventThread(() -> world.context.boats().boats())).isEmpty();
            world.run("address-give-up");

            until("the row is gone", () -> {
                panel.refresh();
                return !rows(panel, "boats-table").contains(nobody.toString());
            });
        }
    }

    private static void shows(BoatListPanel panel, String text) {
        until(text, () -> {
            panel.refresh();
            return rows(panel, "boats-table").contains(text);
        });
    }

    /** The sizes are those that the panel has in a window of 1280 by 800. */
    @ParameterizedTest
    @CsvSource({"100, 655, 200, 3", "150, 655, 148, 2", "200, 630, 440, 2"})
    void boatsAreSeenWithWhatTheyDoAndTheirCharge(int percent, int width, int height, int rows) throws Exception {
        try (TextScale scale = TextScale.percent(percent);
                SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna", "bert", "carl", "dora")) {
            BoatListPanel panel = onEventThread(() -> panel(world));
            JTable table = find(panel, "boats-table", JTable.class);
            until("boats are listed", () -> {
                onEventThread(() -> {
                    panel.refresh();
                    return null;
                });
                return table.getRowCount() == 4;
            });
            onEventThread(() -> {
                Layout.layOut(panel, width, height);
                Rectangle seen = ((JViewport) table.getParent()).getViewRect();
                assertThat(seen.contains(table.getCellRect(rows - 1, 0, true))).isTrue();
                assertThat(width(table, "What it does")).isGreaterThanOrEqualTo(width / 3);
                assertThat(width(table, "Battery")).isGreaterThanOrEqualTo(Look.px(68));
                return null;
            });
        }
    }

    private static int width(JTable table, String column) {
        return Collections.list(table.getColumnModel().getColumns()).stream()
                .filter(shown -> shown.getHeaderValue().equals(column))
                .findFirst()
                .orElseThrow()
                .getWidth();
    }

    private BoatListPanel panel(SessionWorld world) {
        return new BoatListPanel(
                world.context, new ShownPictures(world.context), new WindowSettings(folder.resolve("settings")));
    }
}
