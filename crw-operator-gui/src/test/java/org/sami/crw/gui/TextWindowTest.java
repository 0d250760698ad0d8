package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.message.OperatorMessage;
import org.sami.palette.Theme;
import org.sami.spn.protocol.Priority;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/**
 * The texts of the whole window while much is going on: missions, decisions, messages, an alarm, interrupts; in every theme, at 100 and
 * 150 %, small and large.
 */
@Tag("window")
@TestInstance(Lifecycle.PER_CLASS)
class TextWindowTest {
    private static final List<String> NAMES = List.of("anna", "bert", "carl", "dora", "emil");
    private static final List<Priority> PRIORITIES = List.of(Priority.values());
    private static final List<Dimension> SIZES = List.of(new Dimension(1280, 800), new Dimension(1600, 1000));

    private OpenedWindow opened;
    private LoopbackFleet fleet;
    private OperatorWindow window;

    @BeforeAll
    void open(@TempDir Path data) throws Exception {
        RealDisplay.assumed();
        fleet = new LoopbackFleet(NAMES);
        opened = OpenedWindow.over(fleet.addresses(), data);
        window = opened.window();
        WindowRobot robot = new WindowRobot();
        robot.untilSaid("boats-count", "5 of 5");
        window.session().start("explore-team", "Explore the western bay", Map.of());
        robot.untilSaid("decisions-count", "1 decision");
        window.session().start("connect-boat", "Connect Boat", Map.of());
        robot.untilSaid("decisions-count", "2 decisions");
        for (int i = 0; i < 50; i++) {
            window.session().models().tell(message(i));
        }
        fleet.end("emil");
        robot.untilSaid("links-count", "1 link lost");
        robot.until(
                "an alarm is raised",
                () -> !window.session().models().alarms().snapshot().isEmpty());
    }

    private static OperatorMessage message(int number) {
        return new OperatorMessage(
                0,
                number * 1000L,
                OperatorMessage.Source.PLAN,
                PRIORITIES.get(number % PRIORITIES.size()),
                "Exploring " + (number + 1) * 500 + " m² in " + (number + 1) * 10 + " m of track, for 5 boats",
                List.of("anna"),
                "");
    }

    @AfterAll
    void close() throws Exception {
        if (window != null) {
            opened.end();
        }
        if (fleet != null) {
            fleet.close();
        }
    }

    @Test
    void aSmallWindowHasFewerPanelsBesideOneAnother() {
        WindowInMemory shown = new WindowInMemory(window);
        shown.look(Theme.LIGHT, 100);

        shown.size(1600, 1000);
        assertThat(shown.panelsInSight())
                .containsExactlyInAnyOrder("map", "missions", "boats", "decisions", "interrupts", "messages");
        shown.size(1280, 800);
        assertThat(shown.panelsInSight()).containsExactlyInAnyOrder("map", "missions", "boats", "decisions");
        shown.size(1600, 1000);
        shown.look(Theme.LIGHT, 150);
        shown.size(1600, 1000);
        assertThat(shown.panelsInSight()).containsExactlyInAnyOrder("map", "missions", "boats", "decisions");
    }

    @Test
    void noTextIsCutOrOverlapped() throws Exception {
        WindowInMemory shown = new WindowInMemory(window);
        List<String> faults = new ArrayList<>();
        for (Theme theme : Theme.values()) {
            for (int percent : List.of(100, 150)) {
                shown.look(theme, percent);
                for (Dimension size : SIZES) {
                    if (theme == Theme.DARK && !(percent == 150 && size.equals(SIZES.get(0)))) {
                        continue; // it is Light in other colours: once, where there is the least room
                    }
                    shown.size(size.width, size.height);
                    String what = theme.id() + "-" + percent + "-" + size.width;
                    List<String> here = shown.textFaults();
                    if (!here.isEmpty()) {
                        ImageIO.write(
                                shown.picture(),
                                "png",
                                Path.of("build", "text-" + what + ".png").toFile());
                    }
                    here.forEach(fault -> faults.add(what + ": " + fault));
                }
            }
        }

        assertThat(faults).isEmpty();
    }
}
