package org.sami.dreamm;

import java.io.IOException;
import java.util.List;
import java.util.function.IntConsumer;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.file.RecoveryFolder;
import org.sami.dreamm.file.UnsavedWork;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.window.DreammWindow;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

/** Opens the window over the first project, on the main thread, which may wait. */
final class DreammStart {
    private DreammStart() {}

    /** Opens it; the process ends with the window. */
    static void open(DreammOptions options, FirstProject first, AuthorDirectory data) throws IOException {
        open(options, first, data, System::exit);
    }

    /**
     * Opens it.
     *
     * @param ended is called when the window was closed
     */
    static DreammWindow open(DreammOptions options, FirstProject first, AuthorDirectory data, IntConsumer ended)
            throws IOException {
        List<UnsavedWork> left = RecoveryFolder.leftBehind(data.recovery());
        RecoveryFolder recovery =
                RecoveryFolder.take(data.recovery(), first.domain().vocabulary());
        WindowSettings settings = new WindowSettings(data.settings());
        DreammWindow window = EventThread.get(() -> {
            Look.setHighRows(settings.highRows());
            Look.apply(options.theme().orElse(settings.theme()), options.scale().orElse(settings.scale()));
            settings.keepLook();
            DreammContext context =
                    new DreammContext(first.source(), first.domain(), first.document(), options.profile());
            context.maps().remember(settings.text("map-last"), text -> settings.keep("map-last", text));
            first.plan().ifPresent(context.editor()::open);
            DreammWindow made = new DreammWindow(context, recovery, data, settings, ended);
            if (made.unknownInProfile().isPresent()) {
                made.discard();
            } else {
                made.open();
                made.files().offer(left);
            }
            return made;
        });
        if (window.unknownInProfile().isPresent()) {
            throw new IOException(window.unknownInProfile().get());
        }
        return window;
    }
}
