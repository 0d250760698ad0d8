package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.ui.check.Reach;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.sheet.WindowSheet;

/** Everything in the real window has a name, is large enough for a wet finger and lets the Tab key pass: in all its panels and states. */
@Tag("window")
@TestInstance(Lifecycle.PER_CLASS)
class ReachWindowTest {
    private static final int LEAST = 40;
    private static final String HEADS = "-menu '' Set "; // as high as the heads of panels (docs/windows.md)
    private static final List<String> SHEETS = List.of(
            "boat-connect",
            "boat-pair",
            "boats-ground-station",
            "project-open",
            "map-base",
            "replay-open",
            "help-keys",
            "command-search",
            "mission-start-with");

    private OpenedWindow opened;
    private final Set<String> unnamed = new TreeSet<>();
    private final Set<String> small = new TreeSet<>();
    private final Set<String> keepTab = new TreeSet<>();
    private WindowRobot robot;
    private OperatorWindow window;

    @BeforeAll
    void openAndWalk(@TempDir Path folder) throws Exception {
        RealDisplay.assumed();
        robot = new WindowRobot();
        opened = OpenedWindow.onBuiltInFleet(folder);
        window = opened.window();
        robot.untilSaid("boats-count", "5 of 5");
        WindowInMemory memory = new WindowInMemory(window);
        walk(memory);
        for (String sheet : SHEETS) {
            run(sheet);
            robot.until(
                    sheet + " is shown",
                    () -> WindowSheet.in(window.frame().getRootPane()).isOpen());
            look();
            WindowRobot.ask(() -> {
                WindowSheet.in(window.frame().getRootPane()).close();
                return null;
            });
        }
        window.session().start("explore-team", "", Map.of());
        for (int i = 0; i < 2; i++) { // an area, and how it is divided
            robot.until("it asks", () -> !decisions().isEmpty());
            walk(memory);
            Decision asked = decisions().get(0);
            answer(asked);
            robot.until("it is answered", () -> decisions().stream().noneMatch(other -> other.id() == asked.id()));
        }
        robot.click("interrupt-battery-swap");
        robot.untilShown("interrupt-battery-swap-withdraw");
        robot.scrollTo(robot.find(JComponent.class, "interrupt-proxy-abort"));
        robot.click("interrupt-proxy-abort");
        robot.untilShown("interrupt-confirmation");
        walk(memory);
        run("interrupt-leave");
        run("interrupt-withdraw");
        run("mission-abort");
        robot.untilShown("mission-ending");
        walk(memory);
        window.session().fleet().stopAll();
        robot.untilShown("fleet-release");
        walk(memory);
        window.session().fleet().releaseAll();
    }

    private List<Decision> decisions() {
        return window.session().models().decisions().snapshot().stream()
                .map(pending -> pending.decision())
                .toList();
    }

    private void answer(Decision decision) {
        Question question = decision.question();
        Answer answer = question instanceof Question.ChooseProxies choose
                ? new Answer.Proxies(choose.proxies())
                : question instanceof Question.ChooseOption
                        ? new Answer.Option(0)
                        : question instanceof Question.Approve
                                ? new Answer.YesNo(true)
                                : new Answer.Fields(fields((Question.FillIn) question));
        window.session().answer(decision.id(), answer, "operator");
    }

    private static Map<String, Value> fields(Question.FillIn question) {
        GeoArea area = new GeoArea(
                List.of(
                        GeoPoint.of(25.3596, 51.5272),
                        GeoPoint.of(25.3599, 51.5272),
                        GeoPoint.of(25.3599, 51.5275),
                        GeoPoint.of(25.3596, 51.5275)),
                List.of());
        return Map.of(question.items().get(0).key(), area);
    }

    @AfterAll
    void close() throws Exception {
        if (window != null) {
            opened.end();
        }
    }

    private void run(String command) {
        WindowRobot.ask(() -> {
            window.commands().get(command).run();
            return null;
        });
    }

    private void walk(WindowInMemory memory) {
        memory.eachTab(this::lookNow);
    }

    private void look() {
        WindowRobot.ask(() -> {
            lookNow();
            return null;
        });
    }

    /** On the event thread. */
    private void lookNow() {
        add(unnamed, Reach::unnamed);
        add(
                small,
                root -> Reach.small(root, LEAST).stream()
                        .filter(each -> !each.contains(HEADS))
                        .toList());
        add(keepTab, Reach::keepsTab);
    }

    private void add(Set<String> all, Function<Container, List<String>> found) {
        all.addAll(found.apply(window.frame().getRootPane()));
    }

    @Test
    void theFocusIsSeenWhereverItIs() {
        FocusSeen focus = new FocusSeen(window.frame().getRootPane(), robot);
        new WindowInMemory(window).betweenTabs(focus::look);

        assertThat(focus.unseen()).isEmpty();
    }

    @Test
    void ctrlEnterStartsOnlyAPlanThatIsSeenToBeSelected() {
        run("panel-missions");
        JTabbedPane tabs = robot.find(JTabbedPane.class, "mission-tabs");
        WindowRobot.ask(() -> {
            tabs.setSelectedIndex(1);
            return null;
        });
        int before = missions();

        robot.press(KeyEvent.VK_ENTER, KeyEvent.VK_CONTROL);

        robot.untilShown("plans-table");
        robot.untilSaid("notice", "Nothing has begun");
        assertThat(missions()).isEqualTo(before);
        robot.press(KeyEvent.VK_ENTER, KeyEvent.VK_CONTROL);
        robot.until("it has begun", () -> missions() == before + 1);
    }

    private int missions() {
        return window.session().models().missions().snapshot().missions().size();
    }

    @Test
    void everythingThatIsUsedHasAName() {
        assertThat(unnamed).isEmpty();
    }

    @Test
    void everythingThatIsPressedIsLargeEnough() {
        assertThat(small).isEmpty();
    }

    @Test
    void nothingKeepsTheTabKey() {
        assertThat(keepTab).isEmpty();
    }
}
