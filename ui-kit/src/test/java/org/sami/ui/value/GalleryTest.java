package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.look.Look;

@Tag("long")
@Isolated("the look is one for all windows of a process")
class GalleryTest {
    private static final int WIDTH = 380; // of a docked panel in a window of 1280

    @AfterEach
    void backToTheFirst() {
        Look.apply(Theme.LIGHT, 100);
    }

    @ParameterizedTest
    @CsvSource({"LIGHT,100", "LIGHT,150", "DARK,100", "DARK,150", "SUN,100", "SUN,150"})
    void noTextIsCutOrLiesOnAnother(Theme theme, int percent) {
        Look.apply(theme, percent);

        for (Map.Entry<String, JComponent> one : Gallery.components().entrySet()) {
            JPanel panel = new JPanel(new MigLayout("novisualpadding, insets 8, fillx", "[grow,fill]"));
            panel.add(one.getValue());
            Layout.layOut(panel, Look.px(WIDTH));

            assertThat(TextFit.faults(panel)).as(one.getKey()).isEmpty();
        }
    }
}
