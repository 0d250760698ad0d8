package org.sami.crw.gui;

import java.nio.file.Path;
import java.time.LocalTime;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.sami.crw.gui.remote.ConnectionBand;
import org.sami.crw.gui.remote.RemoteWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.palette.Theme;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.session.server.SessionServer;
import org.sami.ui.EventThread;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

/** The real window over a served session, in which anna takes part by the key of tests. */
final class OpenedRemoteWindow {
    private static final int WITHIN_S = 300;

    private final CompletableFuture<Integer> ended = new CompletableFuture<>();
    private final RemoteSession session;
    private final RemoteWindow window;

    /**
     * Opens one of a server on this machine.
     *
     * @param folder of the window's data and of known servers
     */
    OpenedRemoteWindow(SessionServer server, Path folder) throws Exception {
        this("ws://127.0.0.1:" + server.listensAt().getPort(), "", folder);
    }

    /**
     * Opens one of a session at an address.
     *
     * @param print the SHA-256 of the server's certificate; empty where it has none
     * @param folder of the window's data and of known servers
     */
    OpenedRemoteWindow(String address, String print, Path folder) throws Exception {
        DataDirectory data = DataDirectory.openForSessionElsewhere(folder);
        WindowSettings settings = new WindowSettings(data.settings());
        ConnectionBand band = EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            return new ConnectionBand();
        });
        session = RemoteSession.open(
                List.of(SessionAddress.parse(address)),
                new Login("anna", "key of anna"),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (authority, shown) -> shown.equals(print)),
                EventThread.executor(),
                band,
                LocalTime::now);
        window = EventThread.get(() -> {
            RemoteWindow made = new RemoteWindow(session, band, data, settings, ended::complete);
            made.open();
            return made;
        });
    }

    /** What the window has of the session; its models are read on the event thread. */
    RemoteSession session() {
        return session;
    }

    /** The window. */
    RemoteWindow window() {
        return window;
    }

    /** Runs a command of the window. */
    void run(String command) {
        WindowRobot.ask(() -> {
            window.commands().get(command).run();
            return true;
        });
    }

    /** Closes it; gives the exit code of its program. */
    int end() throws Exception {
        WindowRobot.ask(() -> {
            window.end();
            return true;
        });
        return ended.get(WITHIN_S, TimeUnit.SECONDS);
    }
}
