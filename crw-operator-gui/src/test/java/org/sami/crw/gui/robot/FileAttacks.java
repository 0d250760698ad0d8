package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_B;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_F12;
import static java.awt.event.KeyEvent.VK_J;
import static java.awt.event.KeyEvent.VK_O;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.sami.crw.gui.OpenedWindow;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.operator.health.HealthKind;
import org.sami.ui.look.Look;
import org.sami.ui.map.HeavyFiles;

/** What files do to the window that somebody else has made, or that were damaged. */
final class FileAttacks {
    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow(
                    "A list of open sessions that is no text",
                    "the window starts; the file is set aside, and a fault names it and the newest journal",
                    FileAttacks::openSession),
            new RobotRow(
                    "An arrangement of panels with a document type",
                    "it is not read; it is set aside, and a fault names it; all panels are there",
                    FileAttacks::documentType),
            new RobotRow(
                    "Settings of the window that are nonsense",
                    "the window starts with a theme and a size of letters that there are",
                    FileAttacks::settings),
            new RobotRow(
                    "A base map with a line of 1,000,000 points",
                    "F12 stops the boats while it is read",
                    FileAttacks::longLine),
            new RobotRow(
                    "A base map of 20 MB that is wrong",
                    "the strip says where it is wrong; F12 stops the boats",
                    FileAttacks::wrongLine),
            new RobotRow(
                    "Imagery with an attribution of 50 MB",
                    "it is shown with a part of it; memory lasts",
                    FileAttacks::longAttribution),
            new RobotRow(
                    "A project whose plans are named with HTML",
                    "the names are text in lists and tabs",
                    FileAttacks::htmlProject),
            new RobotRow(
                    "A project without an end",
                    "it is not read; the strip says up to which size projects are",
                    FileAttacks::endlessProject),
            new RobotRow(
                    "A journal with a trigger, replayed",
                    "it is refused with the name of the trigger; the session goes on",
                    FileAttacks::triggeredJournal));

    private static final int POINTS = 1_000_000;

    private FileAttacks() {}

    /** A window whose directory holds an earlier session's journal and three damaged files. */
    static RobotWorld open(Path folder) throws Exception {
        ErrorWatch errors = new ErrorWatch();
        Path data = folder.resolve("data");
        PanelMistakes.unfinished(data);
        Files.write(data.resolve("open-session"), new byte[] {(byte) 0xff, (byte) 0xfe, 0, 10});
        Files.writeString(
                data.resolve("arrangement.xml"),
                "<?xml version=\"1.0\"?>\n<!DOCTYPE app-layout SYSTEM \"http://127.0.0.1:9/layout.dtd\">\n<app-layout/>");
        Files.writeString(data.resolve("window.properties"), "theme=<html>\nscale=huge\nhigh-rows=\u0000\n");
        OpenedWindow window = OpenedWindow.open(
                new StartOptions(
                        List.of(),
                        Optional.of(OpenedWindow.writeBeachWithLibrary(folder.resolve("beach.json"))),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.of(false)),
                data);
        return new RobotWorld(errors, window, RobotWorld.BUILT_IN, folder);
    }

    private static Path data(RobotWorld world) {
        return world.folder.resolve("data");
    }

    /** A fault of a file has it among its details. */
    private static void explained(RobotWorld world, String words) {
        world.until(
                "a fault explains '" + words + "'",
                () -> world.faults(HealthKind.FILE).stream()
                        .anyMatch(entry -> entry.fault().details().contains(words)));
    }

    private static void openSession(RobotWorld world) {
        explained(world, "is not UTF-8 text and was set aside as open-session.damaged");
        assertThat(data(world).resolve("open-session.damaged")).exists();
        assertThat(world.faults(HealthKind.FILE))
                .anyMatch(entry -> entry.fault().details().contains("newest journal"));
    }

    private static void documentType(RobotWorld world) {
        explained(world, "it has a document type; it was set aside as arrangement.xml.damaged");
        assertThat(data(world).resolve("arrangement.xml.damaged")).content().contains("DOCTYPE");
        for (String panel : List.of("map", "boats", "missions", "decisions", "interrupts", "messages")) {
            assertThat(world.isShown(panel)).as(panel).isTrue();
        }
    }

    private static void settings(RobotWorld world) {
        int percent = onEventThread(Look::scalePercent);
        assertThat(percent).isBetween(80, 200);
        assertThat(world.isShown("mission-start")).isTrue();
    }

    private static void openMap(RobotWorld world, Path file) {
        world.robot.press(VK_B, VK_ALT, VK_SHIFT);
        world.typeFile("base-map-file", file);
    }

    private static void stopWhileReading(RobotWorld world) {
        world.robot.press(VK_F12);
        world.until("all boats are stopped", world::allStopped);
    }

    private static void longLine(RobotWorld world) throws Exception {
        Path line = HeavyFiles.line(world.folder.resolve("long.geojson"), POINTS);
        openMap(world, line);
        world.says("map-reading-file", "long.geojson");
        stopWhileReading(world);
        world.robot.until("it is shown", 60, () -> !world.isShown("map-reading"));
    }

    private static void wrongLine(RobotWorld world) throws Exception {
        Path wrong = HeavyFiles.wrongLine(world.folder.resolve("wrong.geojson"), 20_000_000);
        openMap(world, wrong);
        world.robot.until(
                "the strip says what is wrong", 60, () -> world.text("notice").contains("wrong.geojson"));
        stopWhileReading(world);
    }

    private static void longAttribution(RobotWorld world) throws Exception {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(256, 256, BufferedImage.TYPE_INT_RGB), "png", png);
        Path tiles = HeavyFiles.tiles(
                world.folder.resolve("imagery.mbtiles"), 12, 2634, 1748, png.toByteArray(), "©".repeat(25_000_000));
        openMap(world, tiles);
        world.robot.until("it is read", 60, () -> !world.isShown("map-reading"));
        assertThat(world.faults(HealthKind.MEMORY)).isEmpty();
        stopWhileReading(world);
    }

    private static void htmlProject(RobotWorld world) throws Exception {
        String html = "<html><h1>Explore</h1><img src=http://127.0.0.1:9/x>";
        String text = Files.readString(world.folder.resolve("beach.json"))
                .replace("\"Explore Area with interrupts\"", "\"" + html + "\"");
        Path project = Files.writeString(world.folder.resolve("html.json"), text);
        world.robot.press(VK_O, VK_CONTROL);
        world.typeFile("project-file", project);
        world.until(
                "its plan is listed as text",
                () -> SessionWorld.rows(world.opened().window().frame(), "plans-table")
                        .contains(html));
        world.start("explore-team");
        world.until("the tab has the text", () -> world.tabTitles().contains("<h1>Explore</h1>"));
        world.session().project().load(world.folder.resolve("beach.json"));
    }

    private static void endlessProject(RobotWorld world) {
        world.robot.press(VK_O, VK_CONTROL);
        world.typeFile("project-file", Path.of("/dev/zero"));
        world.robot.until(
                "the strip refuses it",
                60,
                () -> world.text("notice").contains("/dev/zero")
                        || world.text("notice").contains("zero"));
    }

    private static void triggeredJournal(RobotWorld world) throws Exception {
        Path earlier;
        try (Stream<Path> journals = Files.list(data(world).resolve("sessions"))) {
            earlier = journals.filter(file -> file.toString().endsWith(".journal"))
                    .min(Path::compareTo)
                    .orElseThrow();
        }
        Path copy = Files.copy(earlier, world.folder.resolve("foreign.journal"));
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + copy);
                Statement statement = connection.createStatement()) {
            statement.execute("CREATE TABLE IF NOT EXISTS spoils (x)");
            statement.execute("CREATE TRIGGER steals AFTER INSERT ON spoils BEGIN DELETE FROM spoils; END");
        } catch (SQLException fault) {
            throw new IOException(fault);
        }
        world.robot.press(VK_J, VK_CONTROL, VK_SHIFT);
        world.typeFile("replay-file", copy);
        world.robot.until("the strip refuses it", 60, () -> world.text("notice").contains("the replay has ended"));
        assertThat(world.text("notice")).contains("foreign.journal");
        assertThat(Files.readString(data(world).resolve("open-session"), StandardCharsets.UTF_8))
                .endsWith(".journal");
    }
}
