package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Window;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.replay.ReplayWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.palette.Theme;
import org.sami.spn.journal.JournalAddress;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.map.MapView;
import org.sami.ui.sheet.WindowSheet;

/**
 * Every word of the operator's window in each domain, in both arrangements, with a mission, a decision, faults, and each sheet and question open once, and then
 * of the replay of that session: boats are not spoken of where copters fly, nor copters where boats are.
 */
@Tag("window")
@Timeout(900)
class RobotWordsWindowTest {
    private static final List<String> SHEETS = List.of(
            "boat-connect",
            "boats-near",
            "boat-pair",
            "phone-add",
            "keys",
            "logs-fetch",
            "project-open",
            "replay-open",
            "command-search",
            "help-keys");

    /** After the end of each session here: a replay goes to its end then. */
    private static final long LATER_MS = 3_600_000;

    private static final List<String> KEY_QUESTIONS = List.of("keys-lost", "keys-export", "keys-import");

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
                .filteredOn(contains("boats?|vessels?|water|hulls?|rudder|quay|drives?|driven"))
                .isEmpty();
        assertThat(words).filteredOn(contains("copters?")).hasSizeGreaterThan(50);
    }

    @Test
    void windowOnBoatsSpeaksOfNoAircraft() throws Exception {
        walk(StartOptions.BOATS, "5 of 5 boats", "anna", "connect-boat");

        assertThat(words)
                .filteredOn(contains("aircraft|copters?|drones?|uavs?|fl(y|ies|own)|altitude"))
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
            run(window, "arrangement-aims");
            JList<?> cards = robot.find(JList.class, "boat-cards");
            robot.until(
                    "a card for each",
                    () -> cards.isShowing() && cards.getModel().getSize() >= 5);
            read(window);
            readQuestion(window, "mission-abort", "mission-end-leave");
            run(window, "arrangement-first");
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
        readReplay(domain);
    }

    /** Reads the session again that has just ended. */
    private void readReplay(String domain) throws Exception {
        StartOptions options = new StartOptions(
                List.of(),
                Optional.empty(),
                Optional.of(Theme.DARK),
                Optional.of(100),
                Optional.empty(),
                Optional.of(JournalAddress.of(journal())),
                Optional.of(LATER_MS),
                Optional.empty(),
                StartOptions.Near.WHEN_ASKED,
                domain);
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        ReplayWindow replay = WindowStart.openReplay(options, DataDirectory.openForReplay(folder), ended::complete);
        try {
            robot.until(
                    "the replay is at its end",
                    () -> SessionWorld.rows(replay.frame(), "boats-table")
                                    .lines()
                                    .count()
                            >= 5);
            read(replay.frame());
        } finally {
            WindowRobot.ask(() -> {
                replay.end();
                return null;
            });
        }
        assertThat(ended.get(300, TimeUnit.SECONDS)).isZero();
    }

    private Path journal() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.toString().endsWith(".journal"))
                    .findFirst()
                    .orElseThrow();
        }
    }

    /** Reads the frame with its menus, commands and each tab in front once. */
    private void read(OperatorWindow window) {
        window.commands().all().forEach(command -> {
            words.add(command.title());
            words.add(WindowRobot.ask(() -> command.whyNot().orElse("")));
        });
        read(window.frame());
    }

    private void read(JFrame frame) {
        new WindowInMemory(frame).eachTab(() -> words.addAll(ShownWords.of(frame)));
    }

    private void readQuestion(OperatorWindow window, String command, String leave) {
        run(window, command);
        robot.untilShown("mission-ending");
        words.addAll(WindowRobot.ask(() -> ShownWords.of(window.frame())));
        run(window, leave);
    }

    /** Reads what is asked in the sheet of the keys before anything is done with them. */
    private void readKeyQuestions(OperatorWindow window) {
        for (String button : KEY_QUESTIONS) {
            robot.click(button);
            robot.untilShown("keys-question");
            words.addAll(WindowRobot.ask(() -> ShownWords.of(window.frame())));
            robot.click("keys-leave");
        }
    }

    private void readSheet(OperatorWindow window, String command) {
        run(window, command);
        robot.until(
                "the sheet of " + command,
                () -> WindowSheet.in(window.frame().getRootPane()).isOpen());
        words.addAll(WindowRobot.ask(() -> ShownWords.of(window.frame())));
        if (command.equals("keys")) {
            readKeyQuestions(window);
        }
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
