package org.sami.crw.gui.robot;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;

/** What operators do wrong with boats, panels and sheets, by robot in the window. */
@Tag("window")
class ControlMistakesWindowTest extends RobotRunTestBase {
    @Override
    List<RobotRow> rows() {
        return Stream.of(FleetMistakes.ROWS, PanelMistakes.ROWS)
                .flatMap(List::stream)
                .toList();
    }

    @Override
    RobotWorld open(Path folder) throws Exception {
        return RobotWorld.withBuiltInFleet(folder);
    }
}
