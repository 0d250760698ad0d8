package org.sami.crw.gui;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import javax.swing.JOptionPane;
import org.sami.crw.gui.replay.ReplayWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.start.WindowSettings;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.crw.session.Session;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;

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
        onEventThread(() -> {
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            return null;
        });
        SessionOpener opener = new SessionOpener(data, options.boats(), options.project());
        Optional<Path> unfinished = data.unfinished();
        boolean goesOn = unfinished.isPresent()
                && options.resume().orElseGet(() -> onEventThread(() -> asksToResume(unfinished.get())));
        Session session = goesOn ? opener.resume(unfinished.get()) : opener.openNew();
        OperatorWindow window = onEventThread(() -> {
            OperatorWindow made = new OperatorWindow(session, options.project(), data, settings, ended);
            made.open();
            return made;
        });
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
        return onEventThread(() -> {
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            ReplayWindow made = new ReplayWindow(journal, data, settings, ended);
            made.open(options.atMillis());
            return made;
        });
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

    private static <T> T onEventThread(Supplier<T> work) {
        CompletableFuture<T> done = new CompletableFuture<>();
        EventThread.later(() -> {
            try {
                done.complete(work.get());
            } catch (RuntimeException | Error fault) {
                done.completeExceptionally(fault);
            }
        });
        try {
            return done.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while the window opens", e);
        } catch (ExecutionException fault) {
            throw new IllegalStateException(
                    "the window cannot be opened: " + fault.getCause().getMessage(), fault.getCause());
        }
    }
}
