package org.sami.crw.gui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.sami.crw.gui.remote.ConnectionBand;
import org.sami.crw.gui.remote.RemoteWindow;
import org.sami.crw.gui.replay.ReplayWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.ResumeQuestion;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.near.BoatFinder;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.crw.session.Session;
import org.sami.palette.ProxyMarks;
import org.sami.session.client.RemoteSession;
import org.sami.spn.protocol.Priority;
import org.sami.ui.EventThread;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.map.MapView;
import org.sami.ui.net.NetView;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;
import org.sami.ui.window.WindowSettings;

/** Opens a session and the window over it, on the main thread, which may wait. */
final class WindowStart {
    private WindowStart() {}

    /** Opens them; the process ends with the window. */
    static void open(StartOptions options, DataDirectory data) throws IOException {
        if (options.replay().isPresent()) {
            openReplay(options, data, System::exit);
        } else if (options.remote().isPresent()) {
            openRemote(options, data, System::exit);
        } else {
            openUnlessLeft(options, data, System::exit);
        }
    }

    /**
     * Opens them.
     *
     * @param ended is called when the window was closed and all with it
     */
    static OperatorWindow open(StartOptions options, DataDirectory data, IntConsumer ended) throws IOException {
        return openUnlessLeft(options, data, ended)
                .orElseThrow(
                        () -> new IllegalStateException("the question whether to go on was left without an answer"));
    }

    /** Opens them; empty where the question whether an unfinished session goes on was left without an answer, and all is closed then. */
    private static Optional<OperatorWindow> openUnlessLeft(StartOptions options, DataDirectory data, IntConsumer ended)
            throws IOException {
        WindowSettings settings = new WindowSettings(data.settings());
        EventThread.get(() -> {
            Look.setHighRows(settings.highRows());
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            return null;
        });
        EventThread.later(WindowStart::loadViews);
        SessionOpener opener = new SessionOpener(data, options);
        Optional<Path> unfinished = data.unfinished();
        data.trouble().ifPresent(trouble -> System.err.println("crw-operator: " + trouble));
        Optional<Boolean> goesOn = unfinished.isEmpty()
                ? Optional.of(false)
                : options.resume().or(() -> ResumeQuestion.ask(unfinished.get(), data.trouble()));
        if (goesOn.isEmpty()) {
            data.close();
            ended.accept(0);
            return Optional.empty();
        }
        Session session = goesOn.get() ? opener.resume(unfinished.get()) : opener.openNew();
        Thread.setDefaultUncaughtExceptionHandler(session.faults().guard()); // of the event thread, above all
        OperatorWindow window = EventThread.get(() -> {
            OperatorWindow made = new OperatorWindow(session, options.project(), data, settings, ended);
            opener.named().ifPresent(made::showConditions);
            opener.simulated().ifPresent(made::showToGroundStations);
            made.lookForBoats(() -> BoatFinder.on(options.near().network()));
            made.open();
            return made;
        });
        data.trouble().ifPresent(trouble -> session.models().health().report(damagedFile(trouble, goesOn.get())));
        session.begin();
        if (options.near().first()) {
            EventThread.later(window.commands().get("boats-near")::run);
        }
        return Optional.of(window);
    }

    /**
     * Opens a replay.
     *
     * @param ended is called when the window was closed
     */
    static ReplayWindow openReplay(StartOptions options, DataDirectory data, IntConsumer ended) throws IOException {
        ReplayedJournal journal = ReplayedJournal.open(options.replay().orElseThrow());
        WindowSettings settings = new WindowSettings(data.settings());
        return EventThread.get(() -> {
            Look.setHighRows(settings.highRows());
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            ReplayWindow made = new ReplayWindow(journal, data, settings, ended);
            made.open(options.atMillis());
            return made;
        });
    }

    /**
     * Opens a window over a session in another process.
     *
     * @param ended is called when the window was closed
     * @throws IOException in words, if the session cannot be taken part in
     */
    static RemoteWindow openRemote(StartOptions options, DataDirectory data, IntConsumer ended) throws IOException {
        WindowSettings settings = new WindowSettings(data.settings());
        ConnectionBand band = EventThread.get(() -> {
            Look.setHighRows(settings.highRows());
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            return new ConnectionBand();
        });
        try {
            RemoteSession session = options.remote().orElseThrow().open(EventThread.executor(), band);
            return EventThread.get(() -> {
                RemoteWindow made = new RemoteWindow(session, band, data, settings, ended);
                made.open();
                return made;
            });
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", stopped);
        }
    }

    private static HealthFault damagedFile(String trouble, boolean goesOn) {
        return HealthFault.of(
                        HealthKind.FILE,
                        "open-session",
                        Priority.LOW,
                        "Which session was not finished is not known: its file is damaged",
                        goesOn
                                ? "See whether this is the session that was not finished"
                                : "To open an earlier one, close the window and write its journal into open-session")
                .withDetails(trouble);
    }

    /** Has the classes of the largest views loaded while the session is opened: the window is there sooner. */
    private static void loadViews() {
        new MapView().close();
        new NetView(new ProxyMarks());
        new RowTable<String>("table", "", row -> row, List.of(RowColumn.words("", 0, row -> row)));
        Icons.normal("stop");
    }
}
