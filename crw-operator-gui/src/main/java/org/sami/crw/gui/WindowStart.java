package org.sami.crw.gui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import javax.swing.JOptionPane;
import org.sami.crw.gui.replay.ReplayWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.crw.session.Session;
import org.sami.spn.protocol.Priority;
import org.sami.ui.EventThread;
import org.sami.ui.look.Icons;
import org.sami.ui.look.IdentityMarks;
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
        } else {
            open(options, data, System::exit);
        }
    }

    /**
     * Opens them.
     *
     * @param ended is told when the window was closed and all with it
     */
    static OperatorWindow open(StartOptions options, DataDirectory data, IntConsumer ended) throws IOException {
        WindowSettings settings = new WindowSettings(data.settings());
        EventThread.get(() -> {
            Look.setHighRows(settings.highRows());
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            return null;
        });
        EventThread.later(WindowStart::loadViews);
        SessionOpener opener = new SessionOpener(data, options.boats(), options.project(), options.conditions());
        Optional<Path> unfinished = data.unfinished();
        data.trouble().ifPresent(trouble -> System.err.println("crw-operator: " + trouble));
        boolean goesOn = unfinished.isPresent()
                && options.resume().orElseGet(() -> EventThread.get(() -> asksToResume(unfinished.get())));
        Session session = goesOn ? opener.resume(unfinished.get()) : opener.openNew();
        OperatorWindow window = EventThread.get(() -> {
            OperatorWindow made = new OperatorWindow(session, options.project(), data, settings, ended);
            opener.named().ifPresent(made::showConditions);
            made.open();
            return made;
        });
        data.trouble().ifPresent(trouble -> session.models().health().report(damagedFile(trouble, goesOn)));
        session.begin();
        return window;
    }

    /**
     * Opens a replay.
     *
     * @param ended is told when the window was closed
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

    private static HealthFault damagedFile(String trouble, boolean goesOn) {
        return HealthFault.of(
                HealthKind.FILE,
                "open-session",
                Priority.LOW,
                trouble,
                goesOn
                        ? "See whether this is the session that was not finished"
                        : "To go on with an earlier session, close the window and write its journal's name into"
                                + " open-session");
    }

    /** Has the classes of the largest views loaded while the session is opened: the window is there sooner. */
    private static void loadViews() {
        new MapView().close();
        new NetView(new IdentityMarks());
        new RowTable<String>("table", "", row -> row, List.of(RowColumn.words("", 0, row -> row)));
        Icons.normal("stop");
    }

    private static boolean asksToResume(Path journal) {
        Object[] answers = {"Go on with it", "Begin anew"};
        String name = journal.getFileName().toString().replace(".journal", "").replace('_', ' ');
        int answer = JOptionPane.showOptionDialog(
                null,
                "The session of " + name + " was not finished.\nIts missions, decisions and boats are in its journal.",
                "SAMI operator",
                JOptionPane.DEFAULT_OPTION,
                JOptionPane.QUESTION_MESSAGE,
                null,
                answers,
                answers[0]);
        return answer == 0;
    }
}
