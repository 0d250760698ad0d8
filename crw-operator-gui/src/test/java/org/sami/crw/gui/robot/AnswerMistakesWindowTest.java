package org.sami.crw.gui.robot;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;

/** What operators do wrong with answers, by robot in the window. */
@Tag("window")
class AnswerMistakesWindowTest extends RobotRunTestBase {
    @Override
    List<RobotRow> rows() {
        return AnswerMistakes.ROWS;
    }

    @Override
    RobotWorld open(Path folder) throws Exception {
        return RobotWorld.withBuiltInFleet(folder);
    }
}
