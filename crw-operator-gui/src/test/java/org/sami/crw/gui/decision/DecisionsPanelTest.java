package org.sami.crw.gui.decision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Map;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.palette.Theme;
import org.sami.spn.protocol.Question;
import org.sami.ui.check.Layout;
import org.sami.ui.look.Look;

/** The panel before a real session with simulated boats: what is asked is answered by what it shows. */
@Tag("long")
@Timeout(900)
class DecisionsPanelTest {
    @Test
    void aMissionIsAskedThroughFromBoatsToTheChosenAllocation() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna", "bert")) {
            world.until(
                    "boats are asked for",
                    () -> world.find("value-decision-option-2", AbstractButton.class)
                            .isPresent());
            assertThat(world.text("decision-asker")).startsWith("clv");
            assertThat(world.enabled("decision-answer")).as("all are proposed").isTrue();

            world.key("choose-1");
            world.key("choose-2");
            assertThat(world.text("decision-problem")).isEqualTo("Choose at least 1");
            assertThat(world.enabled("decision-answer")).isFalse();
            world.key("choose-1");
            world.key("choose-2");
            assertThat(world.text("decision-problem")).isEmpty();
            world.press("decision-answer");

            world.type("value-locations-text", "45.4005, 10.9\n45.4, 10.9005\nquay");
            assertThat(world.text("decision-problem"))
                    .isEqualTo("Locations: Line 3: \"quay\" is not a place; one is 45.7, 10.72");
            assertThat(world.enabled("decision-answer")).isFalse();
            world.type("value-locations-text", "45.4005, 10.9\n45.4, 10.9005\n45.3995, 10.9");
            world.key("answer");

            world.press("value-decision-option-1");
            world.press("decision-answer");

            world.until(
                    "a boat is on its way",
                    () -> world.context.models().fleet().snapshot().stream().anyMatch(boat -> boat.points() > 0));
            world.until(
                    "nothing waits",
                    () -> world.find("decisions-empty", JTextArea.class).isPresent());
        }
    }

    @Test
    void boatsThatAreOfferedSayWhatIsSoNowAndNotWhenItWasAsked() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna", "bert")) {
            world.until(
                    "boats are asked for",
                    () -> world.find("value-decision-option-2", AbstractButton.class)
                            .isPresent());
            world.until("anna lies there", () -> detail(world, 1).contains("no mission wants anything of it"));

            world.session.fleet().stop("anna").toCompletableFuture().join();

            world.until("that is seen", () -> detail(world, 1).contains("it is stopped until it is released"));
            world.until("bert lies there", () -> detail(world, 2).contains("no mission wants anything of it"));
        }
    }

    private static String detail(PanelWorld world, int row) {
        world.panel.refresh();
        return world.text("value-decision-detail-" + row);
    }

    @Test
    void browsingAnswersNothingAndLosesNothing() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            world.session.start("clv", "second", Map.of()).toCompletableFuture().join();
            world.until("two wait", () -> "1 of 2".equals(world.text("decision-position")));
            assertThat(world.text("decision-asker")).startsWith("clv");
            world.key("choose-1");
            assertThat(world.enabled("decision-answer")).as("nobody is chosen").isFalse();

            world.press("decision-later");
            assertThat(world.text("decision-asker")).startsWith("second");
            assertThat(world.enabled("decision-answer")).as("all are proposed").isTrue();

            world.press("decision-earlier");
            assertThat(world.text("decision-asker")).startsWith("clv");
            assertThat(world.enabled("decision-answer"))
                    .as("what was taken off stays off")
                    .isFalse();
            assertThat(world.context.models().decisions().snapshot()).hasSize(2);

            world.key("leave");
            assertThat(world.enabled("decision-answer"))
                    .as("nothing is lost by leaving it")
                    .isFalse();
        }
    }

    @Test
    void pressWithinHalfASecondOfANewQuestionAnswersNothingAndSaysSo() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            JLabel key = new JLabel();
            key.addMouseListener(new MouseAdapter() {
                @Override
                public void mousePressed(MouseEvent press) {
                    world.panel.answer();
                }
            });
            world.until(
                    "boats are asked for",
                    () -> world.find("value-decision-option-1", AbstractButton.class)
                            .isPresent());
            world.session.abortAll();
            world.until(
                    "nothing waits",
                    () -> world.find("decisions-empty", JTextArea.class).isPresent());
            world.wallMillis = () -> 1_000_000;
            world.session.start("clv", "second", Map.of()).toCompletableFuture().join();
            world.until("it is asked again", () -> world.text("decision-asker").startsWith("second"));
            assertThat(world.enabled("decision-answer")).as("all are proposed").isTrue();

            EventQueue queue = Toolkit.getDefaultToolkit().getSystemEventQueue();
            queue.postEvent(press(key, 1_000_499));
            assertThat(world.text("decision-problem")).isEqualTo(DecisionsPanel.UNREAD);
            assertThat(world.enabled("decision-answer"))
                    .as("no answer is under way")
                    .isTrue();

            queue.postEvent(press(key, 1_000_500));
            world.until(
                    "a press after that answers",
                    () -> world.context.models().decisions().snapshot().stream()
                            .anyMatch(one -> one.decision().question() instanceof Question.FillIn));
        }
    }

    private static MouseEvent press(Component at, long whenMillis) {
        return new MouseEvent(at, MouseEvent.MOUSE_PRESSED, whenMillis, 0, 0, 0, 1, false);
    }

    /** A window that was busy handles the second of two quick presses when the next question is there. */
    @Test
    void pressThatWasMadeBeforeAQuestionWasShownAnswersNothing() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            world.session.start("clv", "second", Map.of()).toCompletableFuture().join();
            world.until("two wait", () -> "1 of 2".equals(world.text("decision-position")));
            JLabel key = new JLabel();
            key.addMouseListener(new MouseAdapter() {
                @Override
                public void mousePressed(MouseEvent press) {
                    world.panel.answer();
                }
            });
            MouseEvent early = pressNow(key);
            world.until("time has passed", () -> System.currentTimeMillis() > early.getWhen());
            world.press("decision-later");
            assertThat(world.text("decision-asker")).startsWith("second");

            EventQueue queue = Toolkit.getDefaultToolkit().getSystemEventQueue();
            queue.postEvent(early);
            assertThat(world.text("decision-problem")).isEqualTo(DecisionsPanel.UNREAD);
            assertThat(world.enabled("decision-answer"))
                    .as("no answer is under way")
                    .isTrue();

            queue.postEvent(pressNow(key));
            world.until(
                    "a later press answers",
                    () -> world.context.models().decisions().snapshot().stream()
                            .anyMatch(one -> one.decision().question() instanceof Question.FillIn));
        }
    }

    @Test
    void anAnswerThatIsTakenLeavesTheDecisionThatTheOperatorIsAtByThen() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            world.session.start("clv", "second", Map.of()).toCompletableFuture().join();
            world.session.start("clv", "third", Map.of()).toCompletableFuture().join();
            world.until("three wait", () -> "1 of 3".equals(world.text("decision-position")));
            world.press("decision-later");
            assertThat(world.text("decision-asker")).startsWith("second");

            world.until(
                    "it is answered, and the next is worked on",
                    () -> onEventThread(() -> {
                        world.panel.answer();
                        boolean underWay = world.panel
                                .whyNot()
                                .filter("an answer is under way"::equals)
                                .isPresent();
                        world.panel.browse(underWay ? 1 : -1);
                        if (underWay) {
                            world.panel.choose(0);
                        } else {
                            world.panel.browse(1); // that press is forgotten: it waited for a judgement
                        }
                        return underWay;
                    }));

            world.until(
                    "the answer was taken",
                    () -> world.context.models().decisions().snapshot().stream()
                            .anyMatch(one -> one.decision().question() instanceof Question.FillIn));
            world.until(
                    "nothing is under way",
                    () -> world.panel
                            .whyNot()
                            .filter("an answer is under way"::equals)
                            .isEmpty());
            assertThat(world.text("decision-asker")).startsWith("third");
        }
    }

    @Test
    void pressThatWasMadeBeforeAQuestionWasShownChoosesNothing() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            world.session.start("clv", "second", Map.of()).toCompletableFuture().join();
            world.until("two wait", () -> "1 of 2".equals(world.text("decision-position")));
            JLabel key = new JLabel();
            key.addMouseListener(new MouseAdapter() {
                @Override
                public void mousePressed(MouseEvent press) {
                    world.panel.choose(0);
                }
            });
            MouseEvent early = pressNow(key);
            world.until("time has passed", () -> System.currentTimeMillis() > early.getWhen());
            world.press("decision-later");
            assertThat(world.enabled("decision-answer")).as("all are proposed").isTrue();

            EventQueue queue = Toolkit.getDefaultToolkit().getSystemEventQueue();
            queue.postEvent(early);
            assertThat(world.enabled("decision-answer"))
                    .as("nobody was taken off")
                    .isTrue();

            queue.postEvent(pressNow(key));
            world.until("a later press chooses", () -> !world.enabled("decision-answer"));
        }
    }

    private static MouseEvent pressNow(Component at) {
        return new MouseEvent(at, MouseEvent.MOUSE_PRESSED, System.currentTimeMillis(), 0, 0, 0, 1, false);
    }

    @Test
    void theShownDecisionIsTheSelectedLineAndAnotherLineShowsAnother() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            world.session.start("clv", "second", Map.of()).toCompletableFuture().join();
            world.until("two wait", () -> "1 of 2".equals(world.text("decision-position")));
            JTable queue = onEventThread(() ->
                    Layout.find(world.panel, "decisions-queue", JTable.class).orElseThrow());
            world.until("both are listed", () -> queue.getRowCount() == 2);
            assertThat(onEventThread(queue::getSelectedRow)).isZero();

            onEventThread(() -> {
                queue.setRowSelectionInterval(1, 1);
                return null;
            });
            world.until("the other is shown", () -> world.text("decision-asker").startsWith("second"));
            assertThat(world.context.models().decisions().snapshot()).hasSize(2);

            world.press("decision-earlier");
            assertThat(onEventThread(queue::getSelectedRow)).isZero();
        }
    }

    @Test
    void aDecisionThatEndsElsewhereGivesWay() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna")) {
            world.until(
                    "boats are asked for", () -> world.text("decision-asker").startsWith("clv"));
            world.key("choose-1");

            world.session.abortAll();

            world.until(
                    "nothing waits",
                    () -> world.find("decisions-empty", JTextArea.class).isPresent());
        }
    }

    @Test
    void inALowPanelAtALargeScaleNoButtonIsOutOfSight() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna", "bert")) {
            for (int more = 1; more <= 3; more++) {
                world.session
                        .start("clv", "the long side of the breakwater beside the pier " + more, Map.of())
                        .toCompletableFuture()
                        .join();
            }
            world.until("four wait", () -> "1 of 4".equals(world.text("decision-position")));
            world.press("decision-later");

            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 150);
                SwingUtilities.updateComponentTreeUI(world.panel);
                Layout.layOut(world.panel, 530, 230); // its place in a window of 1280 x 800
                return world.panel;
            });

            for (String name : List.of(
                    "decision-answer", "decision-earlier", "decision-later", "decision-title", "decision-age")) {
                Rectangle seen = onEventThread(() -> {
                    Component part =
                            Layout.find(world.panel, name, Component.class).orElseThrow();
                    return SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), world.panel);
                });
                assertThat(seen.isEmpty()).as("%s has a size", name).isFalse();
                assertThat(new Rectangle(530, 230).contains(seen))
                        .as("%s at %s is in sight", name, seen)
                        .isTrue();
            }
        } finally {
            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 100);
                return null;
            });
        }
    }

    @Test
    void inALowPanelAtALargeScaleWhatIsAskedKeepsItsRoom() throws Exception {
        try (PanelWorld world = new PanelWorld("clv", "anna", "bert")) {
            world.press("decision-answer");
            world.until(
                    "locations are asked for",
                    () -> world.find("value-locations-text", JTextArea.class).isPresent());

            int height = onEventThread(() -> {
                Look.apply(Theme.LIGHT, 150);
                SwingUtilities.updateComponentTreeUI(world.panel);
                Layout.layOut(world.panel, 570, 270);
                return Layout.find(world.panel, "decision-scroll", Component.class)
                        .orElseThrow()
                        .getHeight();
            });

            assertThat(height).isGreaterThan(100);
        } finally {
            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 100);
                return null;
            });
        }
    }

    /** As it is in a window of 1280 by 800 pixels with letters of 150 %. */
    @Test
    void inALowAndNarrowPanelTheReasonIsReadWholeInALineAboveTheButtons() throws Exception {
        try (PanelWorld world = new PanelWorld("explore-area", "anna", "bert")) {
            world.until(
                    "the area is asked for",
                    () -> world.find("value-area-text", JTextArea.class).isPresent());

            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 150);
                SwingUtilities.updateComponentTreeUI(world.panel);
                Layout.layOut(world.panel, 605, 270);

                Component reason = Layout.find(world.panel, "decision-problem-line", Component.class)
                        .orElseThrow();
                Component answer = Layout.find(world.panel, "decision-answer", Component.class)
                        .orElseThrow();
                assertThat(reason.isVisible()).isTrue();
                assertThat(reason.getWidth()).isGreaterThanOrEqualTo(reason.getPreferredSize().width);
                assertThat(answer.getY()).isGreaterThanOrEqualTo(reason.getY() + reason.getHeight());
                return world.panel;
            });
        } finally {
            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 100);
                return null;
            });
        }
    }

    /** As it is in a window of 1280 by 800 pixels with letters of 200 %. */
    @Test
    void inANarrowPanelAtTheLargestScaleNothingIsCutAndTheReasonStandsAboveTheButtons() throws Exception {
        try (PanelWorld world = new PanelWorld("explore-area", "anna", "bert")) {
            world.until(
                    "the area is asked for",
                    () -> world.find("value-area-text", JTextArea.class).isPresent());

            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 200);
                world.map.seen = true;
                world.map.free = false;
                world.panel.refresh();
                SwingUtilities.updateComponentTreeUI(world.panel);
                Layout.layOut(world.panel, 620, 485);

                for (String name : List.of("decision-answer", "decision-draw", "decision-problem", "decision-age")) {
                    Component part =
                            Layout.find(world.panel, name, Component.class).orElseThrow();
                    Rectangle seen = SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), world.panel);
                    assertThat(new Rectangle(620, 485).contains(seen))
                            .as("%s at %s is in sight", name, seen)
                            .isTrue();
                }
                Component reason = Layout.find(world.panel, "decision-problem", Component.class)
                        .orElseThrow();
                assertThat(reason.getWidth()).isGreaterThan(500);
                return world.panel;
            });
        } finally {
            onEventThread(() -> {
                Look.apply(Theme.LIGHT, 100);
                return null;
            });
        }
    }
}
