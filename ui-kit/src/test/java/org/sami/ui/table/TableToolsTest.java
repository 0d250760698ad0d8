package org.sami.ui.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.sami.ui.check.Layout;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;

class TableToolsTest {
    private final JPanel table = new JPanel();
    private final TableTools tools =
            new TableTools(table, List.of(new Command("message-acknowledge", "Acknowledge messages", () -> {})));

    @Test
    void aLowPanelHasItsButtonsBesideTheTable() {
        Layout.layOut(tools, 400, 90);

        assertThat(button("message-acknowledge-icon").isVisible()).isTrue();
        assertThat(button("message-acknowledge").getParent().isVisible()).isFalse();
        assertThat(table.getHeight()).isEqualTo(90);
    }

    @Test
    void aHighPanelHasThemBelowWithTheirTitles() {
        Layout.layOut(tools, 400, 90);
        Layout.layOut(tools, 400, 300);

        assertThat(button("message-acknowledge").getParent().isVisible()).isTrue();
        assertThat(button("message-acknowledge-icon").getParent().isVisible()).isFalse();
        assertThat(table.getWidth()).isEqualTo(400);
    }

    private CommandButton button(String name) {
        return Layout.find(tools, name, CommandButton.class).orElseThrow();
    }
}
