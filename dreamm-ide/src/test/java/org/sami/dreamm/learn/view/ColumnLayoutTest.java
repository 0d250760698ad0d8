package org.sami.dreamm.learn.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JPanel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.sami.palette.Theme;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;

@ResourceLock("look")
class ColumnLayoutTest {
    @AfterEach
    void backToFullSize() {
        EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            return true;
        });
    }

    @Test
    void aColumnHasAllOfTheWidthAtEachScale() {
        for (int percent : new int[] {80, 100, 150, 200}) {
            AtomicInteger width = new AtomicInteger();
            EventThread.get(() -> {
                Look.apply(Theme.LIGHT, percent);
                JPanel column = new JPanel(new ColumnLayout(4));
                JPanel part = new JPanel();
                column.add(part);
                column.setSize(600, 400);
                column.doLayout();
                width.set(part.getWidth());
                return true;
            });
            assertThat(width.get()).as("at %d %%", percent).isEqualTo(600);
        }
    }
}
