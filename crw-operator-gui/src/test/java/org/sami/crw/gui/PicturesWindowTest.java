package org.sami.crw.gui;

import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.crw.session.Session;
import org.sami.spn.protocol.Answer;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** The pictures of a panorama come by themselves; the operator looks at them before the answer, small and large. */
@Tag("window")
class PicturesWindowTest {
    private static final int TURNED_WITHIN_S = 300;

    @TempDir
    private Path folder;

    private final WindowRobot robot = new WindowRobot();

    @Test
    void operatorLooksAtThePicturesOfABoatAndAnswersWhatTheyShow() throws Exception {
        RealDisplay.assumed();
        try (OpenedWindow opened = OpenedWindow.onBuiltInFleet(folder)) {
            OperatorWindow window = opened.window();
            look(window.session());
        }
    }

    private void look(Session session) throws Exception {
        robot.untilSaid("boats-count", "5 of 5");
        session.start("look-around", "look around", Map.of());
        answer(session, decision(session, "OperatorSelectBoatList"), new Answer.Proxies(List.of("anna")));
        robot.until(
                "the pictures are asked about",
                TURNED_WITHIN_S,
                () -> decisions(session).stream()
                        .anyMatch(one -> one.decision().type().equals("OperatorApproveBoats")));
        robot.until("all are here", () -> pictures(session).stream().anyMatch(one -> one.here() == 8));

        robot.untilShown("picture-anna-000003.jpg");
        robot.click("picture-anna-000003.jpg");
        JTextComponent caption = robot.find(JTextComponent.class, "picture-caption");
        robot.until("the third is large", () -> caption.getText().startsWith("anna, picture 3 of 8"));
        robot.untilFocused("picture-large");
        robot.press(KeyEvent.VK_RIGHT, KeyEvent.VK_ALT);
        robot.until(
                "the next one is large, and in front",
                () -> caption.isShowing() && caption.getText().startsWith("anna, picture 4 of 8"));
        robot.press(KeyEvent.VK_LEFT);
        robot.until("the one before is large", () -> caption.getText().startsWith("anna, picture 3 of 8"));

        answer(session, decision(session, "OperatorApproveBoats"), new Answer.YesNo(true));
        robot.until(
                "the target is reported with the pictures",
                () -> session.models().messages().snapshot().stream()
                        .anyMatch(one -> one.message().text().equals("A target is in the pictures of this boat")
                                && PanoramaPictures.shownWith(
                                                        pictures(session),
                                                        one.message().map(),
                                                        one.message().atMillis())
                                                .size()
                                        == 1));
    }

    private static List<PanoramaPictures> pictures(Session session) {
        return session.models().pictures().snapshot();
    }

    private static List<PendingDecision> decisions(Session session) {
        return session.models().decisions().snapshot();
    }

    private PendingDecision decision(Session session, String type) {
        robot.until(
                type + " is asked",
                () -> decisions(session).stream()
                        .anyMatch(one -> one.decision().type().equals(type)));
        return decisions(session).stream()
                .filter(one -> one.decision().type().equals(type))
                .findFirst()
                .orElseThrow();
    }

    private static void answer(Session session, PendingDecision decision, Answer answer) throws Exception {
        session.answer(decision.decision().id(), answer, "test")
                .toCompletableFuture()
                .get(300, TimeUnit.SECONDS);
    }
}
