package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Pattern;
import javax.swing.JLabel;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.protocol.Priority;
import org.sami.ui.check.Layout;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;

/** Panels in which nothing waits leave their room to others, and have it again when something comes. */
@Tag("window")
class EmptyPanelsWindowTest {
    private static final List<Double> FIRST =
            List.of(0.32, 0.58, 0.66, 0.66, 0.38); // of OperatorPanels.FIRST, as the left or upper part

    private final WindowRobot robot = new WindowRobot();
    private OperatorWindow window;

    @TempDir
    private Path folder;

    @Test
    void decisionsHaveRoomWhileOneWaitsAndTheArrangementIsKeptAsItWas() throws Exception {
        RealDisplay.assumed();
        try (LoopbackFleet fleet = new LoopbackFleet(List.of("anna", "bert"))) {
            try (OpenedWindow opened = OpenedWindow.over(fleet.addresses(), folder)) {
                window = opened.window();
                robot.untilSaid("boats-count", "2 of 2");
                robot.until("the plans have the room", () -> height("decisions") < Look.px(130));
                robot.until("interrupts gave theirs away", () -> height("interrupts") < Look.px(130));
                int nothing = WindowRobot.ask(() -> height("messages"));
                window.session().models().tell(message());
                robot.until("messages have their room again", () -> height("messages") > nothing + Look.px(10));
                assertMissionsHaveTheRoomOfDecisions();

                long mission = start();
                robot.until("what is asked has room", () -> height("decisions") > Look.px(300));

                robot.clickAt(panel("decisions"), 20, 45);
                window.session().abort(mission).toCompletableFuture().get(300, TimeUnit.SECONDS);
                boolean isMoved = moveUntilNothingWaits();
                int asked = WindowRobot.ask(() -> height("decisions"));
                assertThat(asked > 300 || !isMoved)
                        .as("nothing moves below a pointer that was just moved; %d pixels", asked)
                        .isTrue();

                robot.until(
                        "the net has the room below a pointer that rests", () -> height("decisions") < Look.px(130));
                assertMissionsHaveTheRoomOfDecisions();
            }
        }
        List<Double> kept = Pattern.compile("roportion=\"([0-9.]+)\"")
                .matcher(Files.readString(folder.resolve("arrangement.xml")))
                .results()
                .map(found -> Double.parseDouble(found.group(1)))
                .toList();
        assertThat(kept)
                .isNotEmpty()
                .allSatisfy(part -> assertThat(FIRST)
                        .as("%s is no proportion of the first arrangement", part)
                        .anyMatch(first -> Math.abs(first - part) < 0.02));
    }

    /** Keeps the pointer moving: on a busy machine it would rest too long before nothing waits. */
    /** Returns whether each move came soon after the one before: on a busy machine the pointer may have rested in between. */
    private boolean moveUntilNothingWaits() {
        JLabel count = robot.find(JLabel.class, "decisions-count");
        AtomicInteger moves = new AtomicInteger();
        AtomicLong movedMs = new AtomicLong(System.nanoTime() / 1_000_000);
        AtomicLong longestMs = new AtomicLong();
        Await.until("nothing waits", () -> {
            boolean over = WindowRobot.ask(() -> count.getText().contains("nothing waits"));
            robot.moveTo(panel("decisions"), 20 + moves.incrementAndGet() % 2, 45);
            long nowMs = System.nanoTime() / 1_000_000;
            longestMs.accumulateAndGet(nowMs - movedMs.getAndSet(nowMs), Math::max);
            return over;
        });
        return longestMs.get() < 3_000;
    }

    private void assertMissionsHaveTheRoomOfDecisions() {
        robot.until(
                "missions have the room, and not the neighbours of the decisions",
                () -> height("missions") > Look.px(420) && height("messages") < Look.px(220));
    }

    private static OperatorMessage message() {
        return new OperatorMessage(
                0,
                1000,
                OperatorMessage.Source.PLAN,
                Priority.MEDIUM,
                "anna has measured 21 °C at its location",
                List.of("anna"),
                "");
    }

    private long start() throws Exception {
        return window.session()
                .start("connect-boat", "", Map.of())
                .toCompletableFuture()
                .get(300, TimeUnit.SECONDS);
    }

    private DockPanel panel(String id) {
        return Layout.find(window.frame(), id, DockPanel.class).orElseThrow();
    }

    private int height(String id) {
        return panel(id).getHeight();
    }
}
