package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JLabel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.remote.ConnectionBand;
import org.sami.crw.gui.remote.RemoteWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.palette.Theme;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.session.person.People;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.StandbyServer;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.ui.EventThread;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

/** The operator's window over a session that one base serves after another: real servers, one session. */
@Tag("window")
class RemoteBasesWindowTest {
    private static final String FIELD = "value-ask-stations-spacing-text";

    @TempDir
    private Path folder;

    @Test
    void windowGoesOnAtTheNextBaseWithWhatIsHalfEntered() throws Exception {
        RealDisplay.assumed();
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        Project project = library.projectOf("station-keep").orElseThrow();
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(library.vocabulary()).text(project),
                library.files().texts(),
                Map.of());
        People people = People.ofThisMachine();
        ServerAddress anywhere = ServerAddress.onThisMachine(0);
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        try (Session session = Session.open(
                        SessionSetup.of(library.vocabulary(), project).with(SessionJournal.none(header)));
                StandbyServer standby = StandbyServer.start(people, anywhere, Optional.empty(), SessionBases.NONE)) {
            int second = standby.listensAt().getPort();
            standby.say("the session is held by laptop-1");
            SessionServer holder = SessionServer.start(
                    session,
                    people,
                    anywhere,
                    Optional.empty(),
                    SessionBases.parse(List.of("ws://127.0.0.1:" + second)));
            session.begin();
            RemoteWindow window = open(holder, ended);
            WindowRobot robot = new WindowRobot();
            session.start("station-keep", "station-keep", Map.of())
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
            try (SessionServer next = SessionServer.start(
                    session, people, ServerAddress.onThisMachine(second), Optional.empty(), SessionBases.NONE)) {
                robot.until(
                        "the other base is named",
                        () -> connection(robot).equals("Session at ws://127.0.0.1:" + second + ", as anna"));

                String title = WindowRobot.ask(() -> window.frame().getTitle());
                assertThat(title).contains("ws://127.0.0.1:" + next.listensAt().getPort());
                String entered = WindowRobot.ask(() -> field.isShowing() ? field.getText() : "");
                assertThat(entered).isEqualTo("12.5");
                WindowRobot.ask(() -> {
                    window.end();
                    return true;
                });
                assertThat(ended.get(300, TimeUnit.SECONDS)).isZero();
            }
        }
    }

    private static String connection(WindowRobot robot) {
        return robot.find(JLabel.class, "connection").getText();
    }

    private RemoteWindow open(SessionServer server, CompletableFuture<Integer> ended) throws Exception {
        DataDirectory data = DataDirectory.openForSessionElsewhere(folder);
        WindowSettings settings = new WindowSettings(data.settings());
        ConnectionBand band = EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            return new ConnectionBand();
        });
        RemoteSession session = RemoteSession.open(
                List.of(SessionAddress.parse(
                        "ws://127.0.0.1:" + server.listensAt().getPort())),
                new Login("anna", ""),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (authority, print) -> false),
                EventThread.executor(),
                band,
                LocalTime::now);
        return EventThread.get(() -> {
            RemoteWindow made = new RemoteWindow(session, band, data, settings, ended::complete);
            made.open();
            return made;
        });
    }
}
