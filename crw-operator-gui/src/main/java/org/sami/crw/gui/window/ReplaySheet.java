package org.sami.crw.gui.window;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.Path;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.ReplayProcess;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.sheet.FileSheet;

/** The sheet with which a journal of this machine is chosen, which is then replayed in a window and process of its own. On the event thread. */
public final class ReplaySheet {
    private ReplaySheet() {}

    /**
     * The command that opens it in the window in which a component lies.
     *
     * @param data the data directory of that window
     * @param from the folder that it shows first
     */
    public static Command command(OperatorContext context, Component inside, Path data, Path from) {
        return new Command("replay-open", "Replay a journal…", () -> {
                    new FileSheet("replay-file", "Replay a journal; this session goes on")
                            .from(from)
                            .open(inside, journal -> replay(context, journal, data));
                })
                .withKey("ctrl shift J")
                .withIcon("clock");
    }

    private static void replay(OperatorContext context, Path journal, Path data) {
        try {
            context.notices().show(journal.getFileName() + " is opened in a window of its own");
            ReplayProcess.start(
                    journal,
                    data,
                    problem -> EventThread.later(() -> context.notices().refused("the replay has ended: " + problem)));
        } catch (IOException fault) {
            context.notices().refused("the replay cannot be started: " + fault.getMessage());
        }
    }
}
