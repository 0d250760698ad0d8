package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_F12;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.sami.crw.gui.FullDiskWindow;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.testing.JavaProcess;

/** What the disk does to the window. */
final class DiskAttacks {
    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow(
                    "The journal's folder moved away under a mission",
                    "a fault says so at once; the mission goes on; F12 stops the boats; it is over when the folder is back",
                    DiskAttacks::folderGone),
            new RobotRow(
                    "A full disk under a mission",
                    "the row of health turns red; F12 stops the boats; the window's program ends with exit code 4",
                    DiskAttacks::fullDisk));

    private static final int LIMIT_KIB = 1200;

    private DiskAttacks() {}

    private static void folderGone(RobotWorld world) throws Exception {
        long mission = world.explore(1);
        Path sessions = world.folder.resolve("data").resolve("sessions");
        Path away = Files.move(sessions, sessions.resolveSibling("pulled-out"));
        try {
            world.until(
                    "a fault says so", () -> !world.faults(HealthKind.JOURNAL).isEmpty());
            world.says("health-worst", "journal");
            assertThat(world.running()).anyMatch(one -> one.id() == mission);
            world.robot.press(VK_F12);
            world.until("all boats are stopped", world::allStopped);
        } finally {
            Files.move(away, sessions);
        }
        world.until("it is over", () -> world.faults(HealthKind.JOURNAL).isEmpty());
    }

    /** A limit of the size of files, as a quota sets it: needs no rights. */
    private static void fullDisk(RobotWorld world) throws Exception {
        assertThat(Path.of("/bin/bash"))
                .as("the shell whose ulimit is the limit")
                .exists();
        Path folder = Files.createDirectory(world.folder.resolve("full"));
        ProcessBuilder limited = JavaProcess.builder(folder, FullDiskWindow.class, folder.toString());
        limited.command().addAll(0, List.of("/bin/bash", "-c", "ulimit -f " + LIMIT_KIB + "; exec \"$@\"", "bash"));
        Path said = world.folder.resolve("full.txt");
        Process process =
                limited.redirectErrorStream(true).redirectOutput(said.toFile()).start();
        try {
            assertThat(process.waitFor(100, TimeUnit.SECONDS)).isTrue();
            String text = Files.readString(said, StandardCharsets.UTF_8);
            assertThat(text)
                    .contains("▲ Missions stand still; the journal cannot be written")
                    .contains("all boats are stopped");
            assertThat(process.exitValue()).as(text).isEqualTo(4);
        } finally {
            process.destroyForcibly();
        }
    }
}
