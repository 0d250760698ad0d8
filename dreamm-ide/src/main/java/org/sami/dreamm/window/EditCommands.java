package org.sami.dreamm.window;

import java.util.Optional;
import org.sami.dreamm.context.DreammContext;
import org.sami.ui.command.Command;

/** Undo and redo. */
final class EditCommands {
    private EditCommands() {}

    static void addTo(DreammContext context) {
        context.commands()
                .add(new Command("undo", "Undo", context::undo)
                        .withKey("ctrl Z")
                        .withIcon("undo")
                        .unless(() -> unless(context.document().undoLabel(), "there is nothing to undo")));
        context.commands()
                .add(new Command("redo", "Redo", context::redo)
                        .withKey("ctrl shift Z")
                        .withIcon("redo")
                        .unless(() -> unless(context.document().redoLabel(), "there is nothing to redo")));
    }

    private static Optional<String> unless(Optional<String> there, String reason) {
        return there.isPresent() ? Optional.empty() : Optional.of(reason);
    }
}
