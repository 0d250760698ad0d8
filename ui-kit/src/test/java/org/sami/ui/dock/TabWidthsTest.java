package org.sami.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.BorderLayout;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.Theme;
import org.sami.ui.EventThread;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class TabWidthsTest {
    private final JPanel area = new JPanel(new BorderLayout());
    private JTabbedPane tabs;

    @AfterEach
    void back() {
        EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            return area;
        });
    }

    private void openFive(int percent) {
        EventThread.get(() -> {
            Look.apply(Theme.LIGHT, percent);
            TabWidths.keep(area);
            tabs = new JTabbedPane();
            area.add(tabs);
            for (String title : new String[] {"Decisions", "Boat", "Interrupts", "Messages", "Allocation"}) {
                tabs.addTab(title, Icons.small("boat"), new JPanel());
            }
            return tabs;
        });
    }

    private void width(int pixels) {
        for (int i = 0; i < 3; i++) { // events of sizes come after the layout
            EventThread.get(() -> {
                area.setSize(pixels, 400);
                area.doLayout();
                tabs.doLayout();
                return tabs;
            });
        }
    }

    private int right(int tab) {
        return EventThread.get(() -> tabs.getBoundsAt(tab).x + tabs.getBoundsAt(tab).width);
    }

    private int widthOf(int tab) {
        return EventThread.get(() -> tabs.getBoundsAt(tab).width);
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 150, 200})
    void allTabsAreInSightWhereTheirWordsHaveNoRoom(int percent) {
        openFive(percent);

        width(Look.px(400));

        assertThat(right(4)).isLessThanOrEqualTo(Look.px(400));
        assertThat(widthOf(0)).as("the front one has its words").isGreaterThan(widthOf(4));
    }

    @Test
    void wordsComeBackWithTheRoomAndGoWithLargerLetters() {
        openFive(100);
        width(400);
        int brief = widthOf(4);

        width(700);
        int full = widthOf(4);
        EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 200);
            SwingUtilities.updateComponentTreeUI(area);
            return area;
        });
        width(700);

        assertThat(full).isGreaterThan(brief);
        assertThat(right(4)).isLessThanOrEqualTo(700);
    }
}
