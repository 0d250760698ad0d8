package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_A;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F12;
import static java.awt.event.KeyEvent.VK_G;
import static java.awt.event.KeyEvent.VK_J;
import static java.awt.event.KeyEvent.VK_P;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_W;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.awt.Component;
import java.awt.Dimension;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JFileChooser;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.proxy.status.LinkState;
import org.sami.palette.Theme;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.ui.EventThread;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;
import org.sami.ui.map.SlowFiles;

/** Drives the real window with its built-in fleet by pointer and keys: one window for all, as docking is for one a process. */
@Tag("window")
@TestInstance(Lifecycle.PER_CLASS)
class OperatorWindowTest {
    private static final int ENDED_TAB = 2; // after the plans and the globals
    private static final int MANY = 6;
    private static final int REPORTS = 42; // at ten a second; a link is lost after 3.5 s

    private Path folder;

    private OpenedWindow opened;
    private WindowRobot robot;
    private OperatorWindow window;

    @BeforeAll
    void open(@TempDir Path data) throws Exception {
        RealDisplay.assumed();
        folder = data;
        robot = new WindowRobot();
        opened = OpenedWindow.onBuiltInFleet(folder);
        window = opened.window();
        robot.untilSaid("boats-count", "5 of 5");
    }

    @AfterAll
    void close() throws Exception {
        if (window != null) {
            opened.end();
        }
    }

    @Test
    void oneClickStartsAMissionAndTwoKeysAbortIt() {
        robot.click("mission-start");
        robot.untilSaid("mission-state", "runs since");
        assertThat(newest().outcome()).isEmpty();

        robot.press(VK_A, VK_CONTROL, VK_SHIFT);
        robot.untilShown("mission-ending");
        robot.press(VK_ENTER);

        robot.untilSaid("mission-state", "aborted");
        assertThat(newest().outcome()).contains(Outcome.ABORTED);
        robot.untilFocused("mission-parts"); // and not the fleet stop
        leaveTheMission();
    }

    @Test
    void oneKeyStopsEveryBoatAndTwoStepsReleaseThem() {
        robot.press(VK_F12);
        robot.until("all boats are stopped", () -> boats().stream().allMatch(OperatorWindowTest::isStopped));

        robot.click("fleet-release");
        assertThat(boats()).allMatch(OperatorWindowTest::isStopped);
        robot.click("fleet-release-confirm");

        robot.until("all boats are released", () -> boats().stream().noneMatch(OperatorWindowTest::isStopped));
    }

    @Test
    void aBoatGoesWhereThePointerSays() {
        robot.clickRow("boats-table", "emil");
        BoatSnapshot before = boat("emil");

        robot.press(VK_G, VK_CONTROL);
        Component map = robot.find(Component.class, "map");
        robot.clickAt(map, map.getWidth() * 3 / 4, map.getHeight() / 2);

        robot.until("emil is under way", () -> boat("emil").points() == 1);
        robot.until(
                "emil has moved",
                () -> boat("emil").pose().orElseThrow().position().lonDeg()
                        > before.pose().orElseThrow().position().lonDeg() + 0.00002);
        assertThat(boat("anna").command()).isEmpty();
    }

    @Test
    void theTabOfTheNewestOfManyMissionsIsSeenWhole() {
        JTabbedPane tabs = robot.find(JTabbedPane.class, "mission-tabs");
        int before = tabs.getTabCount();
        for (int i = 1; i <= MANY; i++) {
            int now = before + i;
            window.session().start("communications-monitoring", "monitoring of the bay", Map.of());
            robot.until(
                    "the mission has a tab",
                    () -> tabs.getSelectedIndex() == tabs.getTabCount() - 1 && tabs.getTabCount() == now);
        }

        robot.until(
                "the newest is seen whole",
                () -> Arrays.stream(tabs.getComponents())
                        .filter(JViewport.class::isInstance)
                        .allMatch(shown -> shown.getBounds().contains(tabs.getBoundsAt(tabs.getSelectedIndex()))));

        window.session().abortAll();
        robot.untilSaid("missions-count", "0 missions");
        robot.clickRow("boats-table", "carl"); // tabs stay while the pointer is on them
        robot.until("those that nobody looks at have left", () -> tabs.getTabCount() == before + 1);
        robot.press(VK_W, VK_CONTROL);
        robot.until("the last one is closed", () -> tabs.getTabCount() == before);
        WindowRobot.ask(() -> {
            tabs.setSelectedIndex(ENDED_TAB);
            return null;
        });
        JTable over = robot.find(JTable.class, "missions-over-table");
        robot.until("those that are over are listed", () -> over.getRowCount() >= MANY);
    }

    @Test
    void theFocusStaysInThePanelsWhereTheyAreArrangedAnew() {
        robot.clickRow("boats-table", "carl");
        robot.untilFocused("boats-table");
        Component messages = robot.find(Component.class, "messages-table");
        Dimension large = WindowRobot.ask(() -> window.frame().getSize());

        resize(new Dimension(1280, 800));

        robot.until("there are fewer panels beside one another", () -> !messages.isShowing());
        robot.untilFocused("boats-table"); // and not the fleet stop
        resize(large);
        robot.until("all are back", messages::isShowing);
    }

    private void resize(Dimension size) {
        WindowRobot.ask(() -> {
            window.frame().setSize(size);
            return null;
        });
    }

    @Test
    void aCommandIsFoundByTypingAndChangesTheWindowAtOnce() {
        robot.press(VK_P, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("command-search-text");
        robot.type("theme sun");
        robot.press(VK_ENTER);

        robot.until("the theme is Sun", () -> Look.theme() == Theme.SUN);
        robot.until("it is kept", () -> kept().contains("theme=sun"));
    }

    private String kept() {
        try {
            return Files.readString(folder.resolve("window.properties"));
        } catch (IOException notYet) {
            return "";
        }
    }

    @Test
    void aSecondWindowNamesTheLock() {
        assertThat(catchThrowable(() -> DataDirectory.open(folder)))
                .hasMessageContaining(folder.resolve("lock").toString());
        assertThat(Files.exists(folder.resolve("open-session"))).isTrue();
    }

    @Test
    void engineAndLinksGoOnWhileTheEventThreadIsBlocked() throws Exception {
        AtomicInteger steps = new AtomicInteger();
        Map<String, Integer> heard = new ConcurrentHashMap<>();
        CountDownLatch unblocked = new CountDownLatch(1);
        try (Registration engine = window.session().addListener((index, atMillis, input, effects, view) -> {
                    if (input instanceof Input.StartMission) {
                        steps.incrementAndGet();
                    }
                });
                Registration fleet = listen(heard)) {
            EventThread.later(() -> awaitOrGiveUp(unblocked));

            window.session().start("communications-monitoring", "monitoring", Map.of());

            Await.until("the engine starts the mission", () -> steps.get() == 1);
            untilReported(heard);
        } finally {
            unblocked.countDown();
        }
        robot.untilSaid("missions-count", "1 mission");
        robot.until("all are linked", () -> boats().stream().allMatch(boat -> boat.link() == LinkState.LINKED));
        robot.untilSaid("links-count", "links fresh");
        window.session().abortAll();
        robot.untilSaid("missions-count", "0 missions");
        leaveTheMission();
    }

    @Test
    void aMapFileThatIsNeverReadStopsNeitherEngineNorLinksNorWindow() throws Exception {
        Path never = SlowFiles.pipe(folder.resolve("shore.geojson"));
        Map<String, Integer> heard = new ConcurrentHashMap<>();
        robot.press(VK_P, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("command-search-text");
        robot.type("base map");
        robot.press(VK_ENTER);
        untilAFileIsAskedFor();
        robot.type(never.toString());
        robot.press(VK_ENTER);
        robot.untilSaid("map-reading-file", "Reading shore.geojson");

        try (Registration fleet = listen(heard)) {
            window.session().start("communications-monitoring", "monitoring", Map.of());
            robot.untilSaid("missions-count", "1 mission");
            untilReported(heard);
        }
        robot.untilSaid("links-count", "links fresh");
        window.session().abortAll();
        robot.untilSaid("missions-count", "0 missions");
        leaveTheMission();
        Component note = robot.find(Component.class, "map-reading");
        robot.click("map-base-stop");

        robot.until("nothing is read any longer", () -> !note.isVisible());
    }

    @Test
    void aFileThatIsNoJournalIsNotReplayedAndTheWindowSaysWhy() throws Exception {
        Path notes = Files.writeString(folder.resolve("notes.txt"), "no journal");
        robot.press(VK_J, VK_CONTROL, VK_SHIFT);
        untilAFileIsAskedFor();
        robot.type(notes.toString());
        robot.press(VK_ENTER);

        robot.untilSaid("notice", "is no journal of SAMI");
    }

    /** Counts what each boat reports. */
    private Registration listen(Map<String, Integer> heard) {
        return window.session().subscribe(Runnable::run, event -> {
            if (event instanceof FleetEvent.StatusReported) {
                heard.merge(event.boat(), 1, Integer::sum);
            }
        });
    }

    private static void untilReported(Map<String, Integer> heard) {
        Await.until(
                "boats report for longer than a link is silent before it is lost",
                () -> heard.size() == 5 && heard.values().stream().allMatch(times -> times >= REPORTS));
    }

    private void leaveTheMission() {
        robot.click("mission-close");
        robot.untilShown("mission-start");
    }

    private void untilAFileIsAskedFor() {
        robot.find(
                JTextField.class,
                name -> name.isFocusOwner() && SwingUtilities.getAncestorOfClass(JFileChooser.class, name) != null);
    }

    private static void awaitOrGiveUp(CountDownLatch unblocked) {
        try {
            assertThat(unblocked.await(60, TimeUnit.SECONDS)).isTrue();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Test
    void missionsBeginAndEndWhileADialogIsOpen() {
        robot.press(VK_P, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("command-search-text");
        robot.type("base map");
        robot.press(VK_ENTER);
        JFileChooser dialog = robot.find(JFileChooser.class, component -> true);

        window.session().start("communications-monitoring", "monitoring", Map.of());
        robot.untilSaid("missions-count", "1 mission");
        window.session().abortAll();
        robot.untilSaid("missions-count", "0 missions");
        robot.untilSaid("links-count", "links fresh");

        robot.press(VK_ESCAPE);
        robot.until("the dialog is gone", () -> !dialog.isShowing());
        leaveTheMission();
    }

    private List<BoatSnapshot> boats() {
        return window.session().models().fleet().snapshot();
    }

    private BoatSnapshot boat(String name) {
        return window.session().models().fleet().boat(name).orElseThrow();
    }

    private MissionSnapshot newest() {
        List<MissionSnapshot> missions =
                window.session().models().missions().snapshot().missions();
        return missions.get(missions.size() - 1);
    }

    private static boolean isStopped(BoatSnapshot boat) {
        return boat.mode().map(mode -> mode == BoatMode.FLEET_STOP).orElse(false);
    }
}
