package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.crw.gui.remote.ConnectionBand;
import org.sami.crw.gui.remote.RemoteWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.session.person.People;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionServer;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.EventThread;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.window.WindowSettings;

/** The session's own window and one over a session elsewhere with the same plans and the same boat, one after the other: what one has and does, the other has and does, but for the exceptions that are listed here. */
@Tag("window")
class BothWindowsWindowTest {
    /** Commands that are run in the session's own window only, and the word of the reason that the window elsewhere gives. */
    private static final Map<String, String> ONLY_AT_THE_MACHINE = Map.of(
            "boats-near", "connect a boat by its address (Ctrl+B)", // networks of that machine
            "boat-pair", "crw keys pair", // keys of that machine
            "phone-add", "crw keys pair",
            "keys", "crw keys list",
            "boats-ground-station", "crw boat --mavlink", // boats that live in the window's process
            "project-open", "crw serve", // a file of that machine
            "fault-boats", "crw serve --on-fault"); // how that machine works

    /** Called otherwise elsewhere: the session goes on without the window. */
    private static final Set<String> OTHER_TITLES = Set.of("end");

    @TempDir
    private Path folder;

    @Test
    void windowElsewhereHasEachCommandAndSaysWhyItCannotRunWhatOnlyTheMachineHas() throws Exception {
        RealDisplay.assumed();
        try (BoatOnTcp boat = new BoatOnTcp(
                BoatSettings.of(
                        "bella",
                        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                        GeoPoint.of(45.4, 10.9),
                        1),
                SteadyClock.ofThisMachine(),
                TcpServerListener.NONE)) {
            BoatAddress at = BoatAddress.parse("127.0.0.1:" + boat.address().getPort());
            Project project;
            Seen here;
            try (OpenedWindow own = OpenedWindow.over(List.of(at), folder.resolve("own"))) {
                CommandRegistry commands = own.window().commands();
                new WindowRobot()
                        .until(
                                "it knows the boat",
                                () -> WindowRobot.ask(
                                        () -> commands.get("boat-add-simulated").isEnabled()
                                                && hasBoat(own.window().session())));
                here = WindowRobot.ask(() -> Seen.of(commands, own.window().frame()));
                project = own.window().session().firstProject();
            }

            JournalHeader header = JournalHeader.of(
                    new ProjectWriter(SessionWorld.LIBRARY.vocabulary()).text(project),
                    SessionWorld.LIBRARY.files().texts(),
                    Map.of());
            try (Session session = Session.open(SessionSetup.of(SessionWorld.LIBRARY.vocabulary(), project)
                            .with(SessionJournal.none(header)));
                    SessionServer server =
                            SessionServer.start(session, People.ofThisMachine(), ServerAddress.onThisMachine(0))) {
                session.begin();
                session.fleet().connect(at).toCompletableFuture().get(300, TimeUnit.SECONDS);
                CompletableFuture<Integer> ended = new CompletableFuture<>();
                RemoteWindow elsewhere = open(server, ended);
                Seen there = WindowRobot.ask(() -> Seen.of(elsewhere.commands(), elsewhere.frame()));

                assertThat(there.titles()).isEqualTo(here.titles());
                assertThat(there.menus()).isEqualTo(here.menus());
                assertThat(differences(here.states(), there.states())).isEmpty();
                ONLY_AT_THE_MACHINE.forEach(
                        (id, why) -> assertThat(there.states().get(id))
                                .as(id)
                                .startsWith("not, as ")
                                .contains(why));
                WindowRobot.ask(() -> {
                    elsewhere.end();
                    return true;
                });
                assertThat(ended.get(300, TimeUnit.SECONDS)).isZero();
            }
        }
    }

    private static boolean hasBoat(Session session) {
        return session.models()
                .fleet()
                .boat("bella")
                .flatMap(BoatSnapshot::pose)
                .isPresent();
    }

    /**
     * A window's commands and menus.
     *
     * @param states whether each command can be run, or why not
     * @param titles with keys, but for those that are called otherwise
     */
    private record Seen(Map<String, String> states, Map<String, String> titles, List<String> menus) {
        static Seen of(CommandRegistry commands, JFrame frame) {
            Map<String, String> states = new TreeMap<>();
            Map<String, String> titles = new TreeMap<>();
            for (Command command : commands.all()) {
                command.refresh();
                states.put(
                        command.id(),
                        command.whyNot().map(why -> "not, as " + why).orElse("can be run"));
                if (!OTHER_TITLES.contains(command.id())) {
                    titles.put(command.id(), command.title() + " " + command.keyText());
                }
            }
            List<String> items = new ArrayList<>();
            for (int i = 0; i < frame.getJMenuBar().getMenuCount(); i++) {
                collect(frame.getJMenuBar().getMenu(i), items);
            }
            return new Seen(states, titles, items);
        }
    }

    /** What can be run in one of the windows only, exceptions apart. */
    private static List<String> differences(Map<String, String> here, Map<String, String> there) {
        List<String> found = new ArrayList<>();
        Set<String> ids = new TreeSet<>(here.keySet());
        ids.addAll(there.keySet());
        ids.removeAll(ONLY_AT_THE_MACHINE.keySet());
        for (String id : ids) {
            String own = here.getOrDefault(id, "missing");
            String other = there.getOrDefault(id, "missing");
            if (!own.equals(other)) {
                found.add(id + ": " + own + " here, " + other + " elsewhere");
            }
        }
        return found;
    }

    private static void collect(JMenu menu, List<String> items) {
        items.add(menu.getText());
        for (int i = 0; i < menu.getItemCount(); i++) {
            JMenuItem item = menu.getItem(i);
            if (item instanceof JMenu inner) {
                collect(inner, items);
            } else if (item != null) {
                items.add(item.getName());
            }
        }
    }

    private RemoteWindow open(SessionServer server, CompletableFuture<Integer> ended) throws Exception {
        DataDirectory data = DataDirectory.openForSessionElsewhere(folder.resolve("other"));
        ConnectionBand band = EventThread.get(ConnectionBand::new);
        RemoteSession session = RemoteSession.open(
                List.of(SessionAddress.parse(
                        "ws://127.0.0.1:" + server.listensAt().getPort())),
                new Login("anna", ""),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (authority, print) -> false),
                EventThread.executor(),
                band,
                LocalTime::now);
        return EventThread.get(() -> {
            RemoteWindow made =
                    new RemoteWindow(session, band, data, new WindowSettings(data.settings()), ended::complete);
            made.open();
            return made;
        });
    }
}
