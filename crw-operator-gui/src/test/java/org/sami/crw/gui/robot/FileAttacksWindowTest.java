package org.sami.crw.gui.robot;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;

/** What damaged and foreign files, and a disk that is full or gone, do to the window, by robot. */
@Tag("window")
class FileAttacksWindowTest extends RobotRunTestBase {
    @Override
    List<RobotRow> rows() {
        return Stream.of(FileAttacks.ROWS, DiskAttacks.ROWS)
                .flatMap(List::stream)
                .toList();
    }

    @Override
    RobotWorld open(Path folder) throws Exception {
        return FileAttacks.open(folder);
    }
}
