package org.sami.crw.gui.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.palette.Theme;
import org.sami.ui.dock.Arrangement;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
class FirstArrangementTest {
    private static final Dimension BELOW_MENU_AND_STRIP = new Dimension(1280, 620); // of a window of 1280 x 800

    @AfterEach
    void back() {
        Look.apply(Theme.LIGHT, 100);
    }

    private static Arrangement at(int percent, Dimension size) {
        Look.apply(Theme.LIGHT, percent);
        return OperatorPanels.FIRST.fitting(size);
    }

    @ParameterizedTest
    @CsvSource({"100,compact", "125,compact", "150,tight", "175,tight", "200,tight"})
    void aWindowOf1280By800HasTwoStacksFromTheScaleOnAtWhichTablesHadNoRow(int percent, String which) {
        assertThat(at(percent, BELOW_MENU_AND_STRIP))
                .isSameAs(which.equals("tight") ? OperatorPanels.FIRST.tight() : OperatorPanels.FIRST.compact());
    }

    @Test
    void aLargeScreenHasTheRoomyOneAtAnyOfTheScalesUpTo175() {
        Dimension large = new Dimension(2560, 1380);

        assertThat(at(100, large)).isSameAs(OperatorPanels.FIRST.roomy());
        assertThat(at(175, large)).isSameAs(OperatorPanels.FIRST.roomy());
        assertThat(at(200, large)).isSameAs(OperatorPanels.FIRST.compact());
    }
}
