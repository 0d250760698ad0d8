package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_EQUALS;
import static java.awt.event.KeyEvent.VK_J;
import static java.awt.event.KeyEvent.VK_P;
import static java.awt.event.KeyEvent.VK_Q;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_SPACE;
import static java.awt.event.KeyEvent.VK_UP;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Point;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JTable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.session.Session;
import org.sami.palette.Theme;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.JournalReader;
import org.sami.spn.protocol.Answer;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;
import org.sami.ui.net.NetView;
import org.sami.ui.replay.SessionClock;

/** Looks at a session again by pointer and keys: the time line dragged and played, moments of a message and of a decision, nothing that acts. */
@Tag("window")
class ReplayWindowTest {
    private static final long BETWEEN_MILLIS = 2000;
    /** It tells something and asks; when it is answered it tells something else and ends. */
    private static final String PROJECT = """
        {"formatVersion": 1, "id": "talk", "name": "Talk", "domain": "crw",
         "missionTree": [{"label": "All", "children": [{"plan": "talk"}]}],
         "plans": [{"id": "talk", "name": "Talk", "places": [
           {"id": "ask", "name": "Ask", "start": true, "outputs": [
             {"id": "m", "type": "DisplayMessage", "fields": {"message": {"value": "before the answer"}}},
             {"id": "q", "type": "OperatorApprove", "fields": {"question": {"value": "Is the water calm?"}}}]},
           {"id": "end", "name": "End", "end": true, "outputs": [
             {"id": "n", "type": "DisplayMessage", "fields": {"message": {"value": "after the answer"}}}]}],
          "transitions": [{"id": "yes", "inputs": [{"id": "i", "type": "YesOption"}]}],
          "inEdges": [{"id": "a", "place": "ask", "transition": "yes",
            "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
          "outEdges": [{"id": "b", "transition": "yes", "place": "end",
            "requirements": [{"action": "take", "n": 1, "kind": "generic"}]}]}]}\
        """;

    @TempDir
    private Path folder;

    private long askedMillis;
    private double waitingShare; // in the middle of the time in which the decision waits, in parts of the session
    private WindowRobot robot;
    private Component bar;
    private JLabel time;
    private AbstractButton play;
    private JTable messages;

    @Test
    void aSessionIsLookedAtAgainAndNothingActs() throws Exception {
        RealDisplay.assumed();
        Path journal = session();
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        StartOptions options = new StartOptions(
                List.of(),
                Optional.empty(),
                Optional.of(Theme.LIGHT),
                Optional.of(100),
                Optional.empty(),
                Optional.of(JournalAddress.of(journal)),
                Optional.empty());
        WindowStart.openReplay(options, DataDirectory.openForReplay(folder), ended::complete);
        robot = new WindowRobot();
        robot.untilSaid("replay-time", "0:00:00 /");
        bar = robot.find(Component.class, "time-line");
        time = robot.find(JLabel.class, "replay-time");
        play = robot.find(AbstractButton.class, "replay-play");
        messages = robot.find(JTable.class, "messages-table");

        goesWhereTheTimeLineIsDragged();
        goesToTheMomentsOfAMessageAndOfADecision();
        spaceIsForTheTextOfAField();
        playsToTheEnd();
        lettersGrowWithTheScale();

        robot.press(VK_Q, VK_CONTROL);
        assertThat(ended.get(300, TimeUnit.SECONDS)).isZero();
    }

    private void lettersGrowWithTheScale() {
        JLabel mark = robot.find(JLabel.class, "replay-mark");
        JLabel file = robot.find(JLabel.class, "replay-file");
        float before = file.getFont().getSize2D();

        robot.press(VK_EQUALS, VK_CONTROL);

        robot.until("letters are larger", () -> file.getFont().getSize2D() > before);
        assertThat(mark.getFont().getSize2D()).isGreaterThan(file.getFont().getSize2D());
    }

    /** Runs a session with that plan, and gives its journal. */
    private Path session() throws Exception {
        Path project = Files.writeString(folder.resolve("talk.json"), PROJECT);
        try (DataDirectory data = DataDirectory.open(folder);
                Session session = new SessionOpener(data, List.of(), Optional.of(project)).openNew()) {
            session.begin();
            session.start("talk", "talk", Map.of()).toCompletableFuture().get(300, TimeUnit.SECONDS);
            Await.until(
                    "it asks", () -> !session.models().decisions().snapshot().isEmpty());
            PendingDecision pending = session.models().decisions().snapshot().get(0);
            long decision = pending.decision().id();
            askedMillis = pending.openedAtMillis();
            Await.until("some time has passed", () -> session.scheduler().nowMs() > askedMillis + BETWEEN_MILLIS);
            long answeredMillis = session.scheduler().nowMs();
            session.answer(decision, new Answer.YesNo(true), "test")
                    .toCompletableFuture()
                    .get(300, TimeUnit.SECONDS);
            Await.until(
                    "it is over", () -> session.models().messages().snapshot().size() == 2);
            Path journal = data.unfinished().orElseThrow();
            try (JournalReader reader = JournalReader.open(journal)) {
                waitingShare = (askedMillis + answeredMillis) / 2.0 / reader.lastMillis();
            }
            return journal;
        }
    }

    private void goesWhereTheTimeLineIsDragged() {
        int y = bar.getHeight() / 3;
        int right = bar.getWidth() - 1;

        robot.draw(bar, new Point(right / 3, y), new Point(right, y));
        robot.until("all messages are there", () -> messages.getRowCount() == 2);
        robot.untilShown("decisions-empty");

        robot.draw(bar, new Point(right, y), new Point(1, y));
        robot.untilSaid("replay-time", "0:00:00 /");
        robot.until("no message is there", () -> messages.getRowCount() == 0);
    }

    private void goesToTheMomentsOfAMessageAndOfADecision() {
        robot.clickAt(bar, bar.getWidth() - 2, bar.getHeight() - 2);
        robot.until("all messages are there", () -> messages.getRowCount() == 2);
        int first = WindowRobot.ask(() -> messages.getValueAt(0, 1).equals("before the answer") ? 0 : 1);
        robot.clickAt(messages, 120, messages.getRowHeight() * first + messages.getRowHeight() / 2);

        robot.press(VK_J, VK_CONTROL);

        robot.until("only the first message is there", () -> messages.getRowCount() == 1);
        robot.untilShown("value-decision-yes");
        NetView net = robot.find(NetView.class, "mission-net");
        robot.until(
                "the net is drawn as it was",
                () -> net.drawing().vertices().size() == 3
                        && !net.marking().at("ask").isEmpty());

        robot.clickAt(bar, (int) (bar.getWidth() * waitingShare), bar.getHeight() - 2);
        robot.untilShown("value-decision-yes");
        robot.press(VK_J, VK_ALT);
        robot.until(
                "it is when the decision was asked", () -> time.getText().startsWith(SessionClock.text(askedMillis)));
        assertThat(robot.find(AbstractButton.class, "decision-answer").getToolTipText())
                .endsWith("this is a replay");
    }

    private void spaceIsForTheTextOfAField() {
        robot.press(VK_P, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("command-search-text");
        robot.type("theme dark");
        robot.press(VK_ENTER);
        robot.until("the theme is dark", () -> Look.theme() == Theme.DARK);
        assertThat(WindowRobot.ask(play::getText)).isEqualTo("Play");
    }

    private void playsToTheEnd() {
        robot.clickAt(bar, 1, bar.getHeight() - 2);
        robot.press(VK_UP, VK_CONTROL);
        robot.press(VK_UP, VK_CONTROL);
        assertThat(robot.find(JComboBox.class, "replay-speed").getSelectedItem())
                .isEqualTo("5 x");

        // three seconds are played so soon that who looks from time to time may miss it
        List<Object> texts = new CopyOnWriteArrayList<>();
        play.addPropertyChangeListener(AbstractButton.TEXT_CHANGED_PROPERTY, change -> texts.add(change.getNewValue()));

        robot.press(VK_SPACE);

        robot.until("it has played to the end", () -> texts.equals(List.of("Pause", "Play")));
        robot.until("all messages are there", () -> messages.getRowCount() == 2);
    }
}
