package org.sami.crw.gui.robot;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;

/** What boats and other clients do to the window over their links, by robot. */
@Tag("window")
class LinkAttacksWindowTest extends RobotRunTestBase {
    @Override
    List<RobotRow> rows() {
        return LinkAttacks.ROWS;
    }

    @Override
    RobotWorld open(Path folder) throws Exception {
        return RobotWorld.withLoopbackFleet(List.of("anna", "bert"), false, folder);
    }
}
