package org.sami.crw.gui.robot;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.ui.check.RealDisplay;

/** A window that is opened once, and rows that are done to it one after another. */
@TestInstance(Lifecycle.PER_CLASS)
abstract class RobotRunTestBase {
    private RobotWorld world;

    /** The rows, in order. */
    abstract List<RobotRow> rows();

    /** Opens the window. */
    abstract RobotWorld open(Path folder) throws Exception;

    Stream<RobotRow> source() {
        return rows().stream();
    }

    @BeforeAll
    void openWindow(@TempDir Path folder) throws Exception {
        RealDisplay.assumed();
        world = open(folder);
    }

    @AfterAll
    void close() throws Exception {
        if (world != null) {
            world.close();
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("source")
    void holds(RobotRow row) throws Exception {
        world.go(row);
    }
}
