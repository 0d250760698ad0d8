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
    private final RemoteWindow window;

    /**
     * Opens one.
     *
     * @param folder of the window's data and of known servers
     */
    OpenedRemoteWindow(SessionServer server, Path folder) throws Exception {
        DataDirectory data = DataDirectory.openForSessionElsewhere(folder);
        WindowSettings settings = new WindowSettings(data.settings());
        ConnectionBand band = EventThread.get(() -> {
            Look.apply(Theme.LIGHT, 100);
            return new ConnectionBand();
        });
        RemoteSession session = RemoteSession.open(
                List.of(SessionAddress.parse(
                        "ws://127.0.0.1:" + server.listensAt().getPort())),
                new Login("anna", "key of anna"),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (authority, print) -> false),
                EventThread.executor(),
                band,
                LocalTime::now);
        window = EventThread.get(() -> {
            RemoteWindow made = new RemoteWindow(session, band, data, settings, ended::complete);
            made.open();
            return made;
        });
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
