package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Window;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.palette.Theme;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.map.MapView;
import org.sami.ui.sheet.WindowSheet;

/** Every word of the operator's window in each domain, with a mission, a decision, faults, and each sheet open once: boats are not spoken of where copters fly. */
@Tag("window")
@Timeout(900)
class RobotWordsWindowTest {
    private static final List<String> SHEETS =
            List.of("boat-connect", "boats-near", "boat-pair", "phone-add", "keys", "logs-fetch");

    private static final Pattern PATH = Pattern.compile("(?<!\\S)/\\S+");

    /** A link by which a phone is paired has words that chance chose. */
    private static final Pattern LINK = Pattern.compile("https?://\\S+");

    @TempDir
    private Path folder;

    private final WindowRobot robot = new WindowRobot();
    private final Set<String> words = new LinkedHashSet<>();

    @Test
    void windowOnCoptersSpeaksOfNoBoat() throws Exception {
        walk("uav", "5 of 5 copters", "copter1", "path-approval");

        assertThat(words)
                .filteredOn(contains("boats?|water|hull|rudder|quay|drives?|driven"))
                .isEmpty();
        assertThat(words).filteredOn(contains("copters?")).hasSizeGreaterThan(50);
    }

    @Test
    void windowOnBoatsSpeaksOfNoAircraft() throws Exception {
        walk(StartOptions.BOATS, "5 of 5 boats", "anna", "connect-boat");

        assertThat(words)
                .filteredOn(contains("aircraft|copters?|uavs?|fl(y|ies|own)|altitude"))
                .isEmpty();
        assertThat(words).filteredOn(contains("boats?")).hasSizeGreaterThan(50);
    }

    /** Whether a text contains a word; absolute paths of files are left out, as the window does not choose them. */
    private static Predicate<String> contains(String word) {
        Predicate<String> contained = Pattern.compile("(?<!\\w)(" + word + ")(?!\\w)", Pattern.CASE_INSENSITIVE)
                .asPredicate();
        return text -> contained.test(
                PATH.matcher(LINK.matcher(text).replaceAll("LINK")).replaceAll("FILE"));
    }

    private void walk(String domain, String linked, String one, String plan) throws Exception {
        RealDisplay.assumed();
        StartOptions options = new StartOptions(
                List.of(),
                Optional.empty(),
                Optional.of(Theme.LIGHT),
                Optional.of(100),
                Optional.of(false),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                StartOptions.Near.WHEN_ASKED,
                domain);
        try (OpenedWindow opened = OpenedWindow.open(options, folder)) {
            OperatorWindow window = opened.window();
            robot.untilSaid("boats-count", linked);
            read(window);
            SHEETS.stream()
                    .filter(sheet -> window.commands().find(sheet).isPresent())
                    .forEach(sheet -> readSheet(window, sheet));
            run(window, "panel-map");
            robot.find(MapView.class, map -> true); // waits until it is in front
            run(window, "map-layers");
            for (MenuElement shown : WindowRobot.ask(MenuSelectionManager.defaultManager()::getSelectedPath)) {
                words.addAll(WindowRobot.ask(() -> ShownWords.of(shown.getComponent())));
            }
            WindowRobot.ask(() -> {
                MenuSelectionManager.defaultManager().clearSelectedPath();
                return null;
            });
            run(window, "panel-boats");
            robot.clickRow("boats-table", one);
            window.session().fleet().connect(BoatAddress.parse("127.0.0.1:1"));
            window.session().start(plan, "Saturday", Map.of());
            robot.untilSaid("decisions-count", "1 decision");
            read(window);
            run(window, "fleet-stop");
            robot.until(
                    "the fleet is stopped",
                    () -> window.session().models().fleetStop().snapshot().isOfFleet());
            read(window);
            WindowRobot.ask(() -> {
                Window frame = window.frame();
                frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING));
                return null;
            });
            robot.untilShown("closing-without-link");
            words.addAll(WindowRobot.ask(() -> ShownWords.of(window.frame())));
        }
    }

    /** Reads the frame with its menus, commands and each tab in front once. */
    private void read(OperatorWindow window) {
        window.commands().all().forEach(command -> {
            words.add(command.title());
            words.add(WindowRobot.ask(() -> command.whyNot().orElse("")));
        });
        new WindowInMemory(window).eachTab(() -> words.addAll(ShownWords.of(window.frame())));
    }

    private void readSheet(OperatorWindow window, String command) {
        run(window, command);
        robot.until(
                "the sheet of " + command,
                () -> WindowSheet.in(window.frame().getRootPane()).isOpen());
        words.addAll(WindowRobot.ask(() -> ShownWords.of(window.frame())));
        WindowRobot.ask(() -> {
            WindowSheet.in(window.frame().getRootPane()).close();
            return null;
        });
    }

    private static void run(OperatorWindow window, String command) {
        WindowRobot.ask(() -> {
            window.commands().get(command).run();
            return null;
        });
    }
}
