package org.sami.dreamm.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.palette.Theme;
import org.sami.ui.dock.Arrangement;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class FirstArrangementTest {
    private static final int MENUS_AND_STATUS = 90;

    @AfterEach
    void back() {
        Look.apply(Theme.LIGHT, 100);
    }

    @ParameterizedTest
    @CsvSource({
        "1920, 1080, 100, roomy", "1600, 1000, 100, roomy", "1280, 800, 100, roomy", "1920, 1080, 150, roomy",
        "1600, 1000, 150, compact", "1280, 800, 150, compact", "2560, 1440, 200, roomy", "1280, 800, 200, tight",
        "1600, 1000, 200, tight"
    })
    void theLessRoomThereIsTheFewerPanelsLieBesideOneAnother(int width, int height, int percent, String which) {
        Look.apply(Theme.LIGHT, percent);

        Arrangement fit = DreammPanels.FIRST.fitting(new Dimension(width, height - Look.px(MENUS_AND_STATUS)));

        assertThat(fit)
                .isSameAs(
                        switch (which) {
                            case "roomy" -> DreammPanels.FIRST.roomy();
                            case "compact" -> DreammPanels.FIRST.compact();
                            default -> DreammPanels.FIRST.tight();
                        });
    }
}
