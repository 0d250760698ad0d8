package org.sami.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.util.List;
import org.junit.jupiter.api.Test;

class ScreenFitTest {
    private static final Rectangle LAPTOP = new Rectangle(0, 0, 1280, 800);
    private static final Rectangle MONITOR = new Rectangle(1280, 0, 1920, 1080);

    @Test
    void windowOfALargerScreenIsMadeAsLargeAsTheScreen() {
        assertThat(ScreenFit.fit(new Rectangle(0, 0, 1600, 1000), List.of(LAPTOP)))
                .isEqualTo(LAPTOP);
    }

    @Test
    void windowOnAMonitorThatIsGoneComesToTheScreenThatIsThere() {
        assertThat(ScreenFit.fit(new Rectangle(1500, 100, 1000, 700), List.of(LAPTOP)))
                .isEqualTo(new Rectangle(280, 100, 1000, 700));
    }

    @Test
    void windowThatLiesPartlyOutsideIsMovedInside() {
        assertThat(ScreenFit.fit(new Rectangle(-200, 300, 1000, 640), List.of(LAPTOP)))
                .isEqualTo(new Rectangle(0, 160, 1000, 640));
    }

    @Test
    void windowThatCanBeSeenWholeStaysWhereItIsAlsoOverTwoScreens() {
        Rectangle overBoth = new Rectangle(1000, 50, 1400, 700);

        assertThat(ScreenFit.fit(overBoth, List.of(LAPTOP, MONITOR))).isEqualTo(overBoth);
    }

    @Test
    void ofTwoScreensTheOneThatShowsMostOfAWindowTakesIt() {
        assertThat(ScreenFit.fit(new Rectangle(1200, 500, 1000, 700), List.of(LAPTOP, MONITOR)))
                .isEqualTo(new Rectangle(1280, 380, 1000, 700));
    }
}
