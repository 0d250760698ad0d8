package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_K;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_SPACE;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** The key with which copters of other makers sign is made, replaced and moved in the copters' window, by keys alone. */
@Tag("window")
@Timeout(900)
@Isolated("what --keys says holds for the whole process")
class VehicleKeyWindowTest {
    private static final String PASSWORD = "in the hangar";

    @TempDir
    private Path folder;

    private final WindowRobot robot = new WindowRobot();
    private final Set<String> words = new LinkedHashSet<>();

    private KeyedWindow open(String laptop) throws Exception {
        KeyedWindow opened = new KeyedWindow(folder.resolve(laptop), "--domain", "uav");
        robot.press(VK_K, VK_ALT, VK_SHIFT);
        robot.untilShown("keys-sheet");
        untilFleet(opened, "No key for vehicles of other makers (MAVLink signing) yet");
        return opened;
    }

    private void untilFleet(KeyedWindow laptop, String text) {
        until(laptop, "keys-fleet", text);
    }

    private void until(KeyedWindow laptop, String name, String text) {
        robot.until(text, () -> SessionWorld.text(laptop.window.frame(), name).contains(text));
        words.addAll(WindowRobot.ask(() -> ShownWords.of(laptop.window.frame())));
    }

    private String print(String laptop) throws Exception {
        return new BaseKeys(KeyedWindow.keys(folder.resolve(laptop)))
                .shownFleetKey()
                .orElseThrow()
                .fingerprint();
    }

    @Test
    void keyIsMadeReplacedAfterAQuestionAndTakenToASecondLaptop() throws Exception {
        RealDisplay.assumed();
        Path file = folder.resolve("fleet.keys");
        String replaced;
        try (KeyedWindow first = open("first")) {
            robot.press(VK_K, VK_ALT);
            until(first, "keys-said", "The key is made");
            robot.untilFocused("keys-table"); // and not the fleet stop, which a further key would press
            String made = print("first");
            untilFleet(first, "(MAVLink signing): " + made + ", here since 20");
            untilFleet(
                    first,
                    "crw keys fleet --keys " + KeyedWindow.keys(folder.resolve("first")) + " --give mavlink:serial:");

            robot.press(VK_K, VK_ALT);
            until(first, "keys-question-words", "Replace the key " + made);
            robot.untilFocused("keys-leave");
            robot.press(VK_SPACE);
            robot.untilShown("keys-fleet-new");
            assertThat(print("first")).as("it was left").isEqualTo(made);

            robot.press(VK_K, VK_ALT);
            robot.click("keys-answer");
            until(first, "keys-said", "The key is replaced");
            replaced = print("first");
            assertThat(replaced).isNotEqualTo(made);
            untilFleet(first, replaced);

            robot.click("keys-export");
            until(first, "keys-question-words", "also that of vehicles of other makers");
            answer(file, "keys-password", "keys-repeated");
            until(first, "keys-said", "vehicles sign with the key " + replaced);
            robot.press(VK_ESCAPE);
        }
        try (KeyedWindow second = open("second")) {
            robot.click("keys-import");
            answer(file, "keys-password");
            until(second, "keys-said", "vehicles sign with the key " + replaced);
            untilFleet(second, replaced);
        }
        assertThat(words)
                .filteredOn(text -> text.toLowerCase(Locale.ROOT).contains("boat"))
                .isEmpty();
    }

    private void answer(Path file, String... passwords) {
        KeyedWindow.type(robot, "keys-file", file.toString());
        for (String field : passwords) {
            KeyedWindow.type(robot, field, PASSWORD);
        }
        robot.press(VK_ENTER);
    }
}
