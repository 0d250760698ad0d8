package org.sami.crw.gui.file;

import java.awt.Component;
import java.nio.file.Path;
import java.util.Optional;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.session.file.LogFetch;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.sheet.FileSheet;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The sheet with which boats' logs are fetched. The fetch goes on while it is closed, and says at the top what came of it. On the event thread. */
public final class LogsSheet {
    private final OperatorContext context;
    private final Component inside;
    private final LogFetch fetch;
    private Optional<LogsForm> shown = Optional.empty();
    private Path folder = Path.of(System.getProperty("user.home"), "sami-logs");
    private boolean ran;

    /** A sheet of the window in which a component lies. */
    public LogsSheet(OperatorContext context, Component inside) {
        this.context = context;
        this.inside = inside;
        fetch = new LogFetch(
                EventThread.executor(), boat -> context.session().fleet().files(boat), this::changed);
    }

    /** The command that opens it. */
    public Command command() {
        return new Command("logs-fetch", "Fetch logs…", this::open)
                .withKey("alt shift L")
                .withIcon("file");
    }

    /** Opens it. */
    public void open() {
        LogsForm form = new LogsForm(context, fetch, folder, this::choose);
        WindowSheet.in(inside)
                .open(new Sheet("logs-sheet", "Fetch logs", form).whenClosed(() -> shown = Optional.empty()));
        shown = Optional.of(form);
    }

    private void choose(Path from) {
        new FileSheet("logs-folder-file", "Choose the folder for the logs")
                .from(from)
                .orFolder()
                .open(inside, chosen -> {
                    folder = chosen;
                    open();
                });
    }

    private void changed() {
        shown.ifPresent(LogsForm::refresh);
        boolean ended = ran && !fetch.isRunning();
        ran = fetch.isRunning();
        if (ended && shown.isEmpty() && fetch.isBad()) {
            context.notices().refused(fetch.said());
        } else if (ended && shown.isEmpty()) {
            context.notices().show(fetch.said());
        }
    }

    /** Ends the fetch with the window; what has come is kept. */
    public void end() {
        fetch.cancel();
    }
}
