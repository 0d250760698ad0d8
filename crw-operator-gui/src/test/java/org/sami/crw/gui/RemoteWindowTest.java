package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.gui.remote.RemoteWindow;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.session.person.PersonRole;
import org.sami.session.server.SessionServer;
import org.sami.session.server.testing.ServedSession;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.command.Command;
import org.sami.ui.value.WrappedText;

/** The operator's window over a session behind a real server: a question answered by pressing, the fleet stopped, the server gone. */
@Tag("window")
class RemoteWindowTest {
    /** A plan that asks once, with a message after the answer. */
    static final String PROJECT = """
        {"formatVersion": 1, "id": "talk", "name": "Talk", "domain": "crw",
         "missionTree": [{"label": "All", "children": [{"plan": "talk"}]}],
         "plans": [{"id": "talk", "name": "Talk", "places": [
           {"id": "ask", "name": "Ask", "start": true, "outputs": [
             {"id": "q", "type": "OperatorApprove", "fields": {"question": {"value": "Is the water calm?"}}}]},
           {"id": "end", "name": "End", "end": true, "outputs": [
             {"id": "n", "type": "DisplayMessage", "fields": {"message": {"value": "after the answer"}}}]}],
          "transitions": [{"id": "yes", "inputs": [{"id": "i", "type": "YesOption"}]}],
          "inEdges": [{"id": "a", "place": "ask", "transition": "yes",
            "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
          "outEdges": [{"id": "b", "transition": "yes", "place": "end",
            "requirements": [{"action": "take", "n": 1, "kind": "generic"}]}]}]}\
        """;

    /** Commands of the window itself, by how their ids begin. */
    private static final List<String> OF_THE_WINDOW =
            List.of("panel-", "theme-", "map-", "net-", "gantt-", "picture-", "scale-", "arrangement-", "alarm-hear-");

    @TempDir
    private Path folder;

    @Test
    void showsTheSessionAnswersStopsAndSaysWhenTheServerIsGone() throws Exception {
        RealDisplay.assumed();
        try (ServedSession served = ServedSession.ofProject(PROJECT, folder).with("anna", PersonRole.OPERATOR)) {
            Session session = served.session();
            SessionServer server = served.serve();
            served.begin();
            OpenedRemoteWindow opened = new OpenedRemoteWindow(server, folder);
            RemoteWindow window = opened.window();
            WindowRobot robot = new WindowRobot();
            robot.untilSaid("connection", "Session at ws://127.0.0.1:");

            session.start("talk", "talk", Map.of()).toCompletableFuture().get(300, TimeUnit.SECONDS);
            robot.untilSaid("missions-count", "1 mission");
            robot.untilSaid("decisions-count", "1 decision");
            robot.untilShown("value-decision-yes");
            AbstractButton yes = robot.find(AbstractButton.class, "value-decision-yes");
            WindowRobot.ask(() -> {
                yes.doClick(); // which answers
                return true;
            });
            robot.until(
                    "the answer has arrived",
                    () -> session.models().decisions().snapshot().isEmpty());

            opened.run("arrangement-aims");
            JList<?> cards = robot.find(JList.class, "boat-cards");
            robot.until("boats stand on the left with their pictures", cards::isShowing);
            opened.run("panel-gantt");
            JComponent chart = robot.find(JComponent.class, "gantt-chart");
            robot.until(
                    "the mission is seen over time",
                    () -> chart.isShowing()
                            && chart.getAccessibleContext()
                                    .getAccessibleDescription()
                                    .startsWith("Talk"));
            opened.run("arrangement-first");

            opened.run("fleet-stop");
            robot.until(
                    "the fleet is stopped",
                    () -> session.models().fleetStop().snapshot().everyBoat());
            assertThat(window.commands().get("globals-save").isEnabled()).isFalse();

            server.close();
            robot.until(
                    "the loss is said",
                    () -> robot.find(JLabel.class, "connection").getText().contains("connection lost ("));
            assertThat(opened.end()).isZero();
            assertThat(session.faults().failure()).isEmpty();
        }
    }

    @Test
    void observerSeesWhatItMayNotDoAsLockedAndCanStopTheFleet() throws Exception {
        RealDisplay.assumed();
        try (ServedSession served = ServedSession.ofProject(PROJECT, folder).with("anna", PersonRole.OBSERVER);
                SessionServer server = served.serve()) {
            served.begin();
            OpenedRemoteWindow opened = new OpenedRemoteWindow(server, folder);
            RemoteWindow window = opened.window();
            WindowRobot robot = new WindowRobot();
            robot.untilSaid("connection", "Session at ws://127.0.0.1:");

            assertThat(window.commands().get("mission-start").whyNot())
                    .contains("your role in this session, observer, may not start or end missions, or connect boats");
            assertThat(window.commands().get("boat-by-hand").whyNot().orElseThrow())
                    .endsWith("may not drive boats or fetch their logs");
            assertThat(window.commands().all())
                    .filteredOn(command -> command.whyNot().orElse("").startsWith("your role in this session, "))
                    .extracting(Command::id)
                    .containsExactlyInAnyOrder(
                            "decision-answer",
                            "decision-refuse",
                            "decision-stop-timer",
                            "decision-draw",
                            "alarm-acknowledge",
                            "message-acknowledge",
                            "allocation-give",
                            "fleet-release",
                            "fleet-release-confirm",
                            "boat-release",
                            "interrupt-confirm",
                            "interrupt-withdraw",
                            "interrupt-1",
                            "interrupt-2",
                            "interrupt-3",
                            "interrupt-4",
                            "interrupt-5",
                            "interrupt-6",
                            "interrupt-7",
                            "interrupt-8",
                            "mission-start",
                            "mission-start-with",
                            "mission-abort",
                            "mission-complete",
                            "mission-end-confirm",
                            "mission-send-again",
                            "global-set",
                            "boat-connect",
                            "boat-disconnect",
                            "boat-add-simulated",
                            "address-give-up",
                            "boat-by-hand",
                            "boat-try-motor",
                            "boat-take",
                            "boat-hand-over",
                            "boat-resend",
                            "boat-clear-block",
                            "boats-go",
                            "boats-home",
                            "boats-hold",
                            "boats-give-back",
                            "boat-cancel-command",
                            "logs-fetch",
                            "boat-set-heading",
                            "boat-set-speed",
                            "boat-set-velocity",
                            "boat-set-lost-link",
                            "boat-set-lost-link-wish",
                            "boat-set-wished-lost-link");
            assertThat(window.commands().all())
                    .filteredOn(command -> !command.whyNot().orElse("").startsWith("your role in this session, "))
                    .extracting(Command::id)
                    .as("what any role may do: a new command stands here, or has its right in RightsPolicy")
                    .filteredOn(id -> OF_THE_WINDOW.stream().noneMatch(id::startsWith))
                    .containsExactlyInAnyOrder(
                            "fleet-stop",
                            "boat-stop",
                            "boats-near", // what only the session's own machine has
                            "boat-pair",
                            "phone-add",
                            "keys",
                            "boats-ground-station",
                            "project-open",
                            "globals-save",
                            "fault-boats", // what is looked at
                            "replay-open",
                            "boat-picture",
                            "boats-pictures",
                            "plans-find",
                            "mission-show-ended",
                            "mission-end-leave",
                            "mission-close",
                            "mission-sub-mission",
                            "decision-pictures",
                            "decision-later",
                            "decision-earlier",
                            "decision-option-next",
                            "decision-option-before",
                            "decision-focus",
                            "message-pictures",
                            "alarm-mute",
                            "alarm-sounds",
                            "interrupt-leave",
                            "rows-high",
                            "command-search",
                            "help-keys",
                            "panels-reset",
                            "end");
            assertThat(window.commands().get("fleet-stop").isEnabled()).isTrue();
            assertThat(opened.end()).isZero();
        }
    }

    @Test
    void observerWhoPressesYesOrEnterAnswersNothingAndReadsWhy() throws Exception {
        RealDisplay.assumed();
        try (ServedSession served = ServedSession.ofProject(PROJECT, folder).with("anna", PersonRole.OBSERVER);
                SessionServer server = served.serve()) {
            served.begin();
            OpenedRemoteWindow opened = new OpenedRemoteWindow(server, folder);
            WindowRobot robot = new WindowRobot();
            served.session()
                    .start("talk", "talk", Map.of())
                    .toCompletableFuture()
                    .get(300, TimeUnit.SECONDS);
            robot.untilShown("value-decision-yes");
            AbstractButton yes = robot.find(AbstractButton.class, "value-decision-yes");
            WindowRobot.ask(() -> {
                yes.doClick();
                return true;
            });

            robot.until(
                    "why is said",
                    () -> robot.find(WrappedText.class, "decision-problem")
                            .getText()
                            .equals("your role in this session, observer, may not answer decisions"));
            assertThat(served.session().models().decisions().snapshot()).hasSize(1);
            assertThat(opened.end()).isZero();
        }
    }

    @Test
    void connectsABoatAndSetsItsSettingsUntilTheRoleIsAnother() throws Exception {
        RealDisplay.assumed();
        try (ServedSession served = ServedSession.ofProject(PROJECT, folder).with("anna", PersonRole.OPERATOR);
                SessionServer server = served.serve();
                BoatOnTcp boat = new BoatOnTcp(
                        BoatSettings.of(
                                "bella",
                                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                                GeoPoint.of(45.4, 10.9),
                                1),
                        new SteadyClock(ProcessClock::ms),
                        TcpServerListener.NONE)) {
            served.begin();
            OpenedRemoteWindow opened = new OpenedRemoteWindow(server, folder);
            RemoteWindow window = opened.window();
            WindowRobot robot = new WindowRobot();
            robot.untilSaid("connection", "Session at ws://127.0.0.1:");
            opened.run("boat-connect");
            JTextField address = robot.find(JTextField.class, "boat-connect-address");
            AbstractButton connect = robot.find(AbstractButton.class, "boat-connect-do");
            WindowRobot.ask(() -> {
                address.setText("127.0.0.1:" + boat.address().getPort());
                connect.doClick();
                return true;
            });
            WrappedText answer = robot.find(WrappedText.class, "boat-connect-said");
            robot.until(
                    "the boat has answered",
                    () -> answer.getText()
                            .equals("✓ 127.0.0.1:" + boat.address().getPort() + " is connected as bella"));
            robot.press(KeyEvent.VK_ESCAPE);
            robot.clickRow("boats-table", "bella");
            opened.run("panel-boat");
            JTabbedPane tabs = robot.find(JTabbedPane.class, "boat-tabs");
            WindowRobot.ask(() -> {
                tabs.setSelectedIndex(tabs.indexOfTab("Settings"));
                return true;
            });
            JTextField multiplier = robot.find(JTextField.class, "boat-velocity");
            robot.until(
                    "its settings are known",
                    () -> said(robot, "boat-velocity-now").equals("in force: 1"));

            WindowRobot.ask(() -> {
                multiplier.setText("0.5");
                window.commands().get("boat-set-velocity").run();
                return true;
            });
            robot.until("it is taken", () -> said(robot, "boat-velocity-now").equals("in force: 0.5   ✓ taken"));

            JComboBox<?> wish = robot.find(JComboBox.class, "boat-lost-link-wish");
            WindowRobot.ask(() -> {
                wish.setSelectedItem(LostLinkAction.RETURN);
                window.commands().get("boat-set-lost-link-wish").run();
                return true;
            });
            robot.until(
                    "the session wishes it",
                    () -> said(robot, "boat-lost-link-wish-now").equals("in force: returns to its home   ✓ taken"));
            opened.run("boat-set-wished-lost-link");
            robot.until(
                    "the boat does it", () -> said(robot, "boat-lost-link-now").startsWith("in force: returns"));

            Files.writeString(
                    served.people().file(),
                    Files.readString(served.people().file()).replace("operator", "pilot"));
            robot.until(
                    "the window knows the role",
                    () -> window.commands()
                            .get("boat-set-velocity")
                            .whyNot()
                            .equals(Optional.of("your role in this session, pilot, may not set up boats")));
            assertThat(window.commands().get("boat-by-hand").whyNot().orElse(""))
                    .doesNotContain("your role");
            Files.writeString(
                    served.people().file(),
                    Files.readString(served.people().file()).replace("pilot", "operator"));
            robot.until(
                    "the lock is ended",
                    () -> window.commands().get("boat-set-velocity").whyNot().isEmpty());
            assertThat(opened.end()).isZero();
        }
    }

    private static String said(WindowRobot robot, String label) {
        return robot.find(JLabel.class, label).getText();
    }
}
