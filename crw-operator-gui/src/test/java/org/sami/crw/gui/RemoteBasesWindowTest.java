package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.StandbyServer;
import org.sami.session.server.testing.ServedSession;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** The operator's window over a session that one base serves after another: real servers, one session. */
@Tag("window")
class RemoteBasesWindowTest {
    private static final String FIELD = "value-ask-stations-spacing-text";

    @TempDir
    private Path folder;

    @Test
    void windowGoesOnAtTheNextBaseWithWhatIsHalfEntered() throws Exception {
        RealDisplay.assumed();
        try (ServedSession served = ServedSession.ofPlan("station-keep", folder).with("anna", PersonRole.OPERATOR);
                StandbyServer standby = StandbyServer.start(
                        served.people(), ServerAddress.onThisMachine(0), Optional.empty(), SessionBases.NONE)) {
            int second = standby.listensAt().getPort();
            standby.say("the session is held by laptop-1");
            SessionServer holder = served.serve(
                    ServerAddress.onThisMachine(0), SessionBases.parse(List.of("ws://127.0.0.1:" + second)));
            served.begin();
            OpenedRemoteWindow opened = new OpenedRemoteWindow(holder, folder);
            WindowRobot robot = new WindowRobot();
            served.session()
                    .start("station-keep", "station-keep", Map.of())
                    .toCompletableFuture()
                    .get(300, TimeUnit.SECONDS);
            robot.untilSaid("decisions-count", "1 decision");
            robot.untilShown(FIELD);
            JTextField field = robot.find(JTextField.class, FIELD);
            WindowRobot.ask(() -> {
                field.setText("12.5");
                return true;
            });

            holder.close();
            robot.until("the loss is said", () -> connection(robot).contains("; trying ws://127.0.0.1:"));
            robot.until("who holds it is said", () -> connection(robot).contains("the session is held by laptop-1"));
            standby.close();
            try (SessionServer next = served.serve(ServerAddress.onThisMachine(second), SessionBases.NONE)) {
                robot.until(
                        "the other base is named",
                        () -> connection(robot).equals("Session at ws://127.0.0.1:" + second + ", as anna"));

                String title = WindowRobot.ask(() -> opened.window().frame().getTitle());
                assertThat(title).contains("ws://127.0.0.1:" + next.listensAt().getPort());
                String entered = WindowRobot.ask(() -> field.isShowing() ? field.getText() : "");
                assertThat(entered).isEqualTo("12.5");
                assertThat(opened.end()).isZero();
            }
        }
    }

    private static String connection(WindowRobot robot) {
        return robot.find(JLabel.class, "connection").getText();
    }
}
