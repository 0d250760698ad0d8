package org.sami.dreamm.canvas;

import java.util.Optional;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.ui.canvas.CanvasKey;
import org.sami.ui.command.Command;
import org.sami.ui.net.NetView;

/** Adds commands of the net to the window's, with keys that the canvas has while it has the focus, and knows when they can be run. */
final class NetCommands {
    private final DreammContext context;
    private final NetView view;
    private final NetActions actions;

    NetCommands(DreammContext context, NetView view, NetActions actions) {
        this.context = context;
        this.view = view;
        this.actions = actions;
    }

    /**
     * Adds a command.
     *
     * @param whyNot why it cannot be run now; one of the conditions below, or its own
     * @param keys while the net has the focus
     */
    Command add(String id, String title, Runnable run, Supplier<Optional<String>> whyNot, String... keys) {
        Command command = context.commands()
                .add(new Command(id, title, () -> {
                            view.canvas().requestFocusInWindow(); // the next key is meant for the net, too
                            run.run();
                        })
                        .withFocusKeys(CanvasKey.strokes(keys))
                        .unless(whyNot));
        command.bindTo(view.canvas());
        return command;
    }

    /** A plan is open, and the profile allows the command. */
    Supplier<Optional<String>> open(String id) {
        return () -> actions.whyNotEdit(id);
    }

    /** Something is selected as well. */
    Supplier<Optional<String>> selected(String id) {
        return () -> actions.whyNotEdit(id)
                .or(() -> actions.selection().isEmpty() ? Optional.of("nothing is selected") : Optional.empty());
    }

    /** One vertex is selected as well. */
    Supplier<Optional<String>> oneVertex(String id) {
        return () -> actions.whyNotEdit(id)
                .or(() -> actions.selectedVertex().isPresent() ? Optional.empty() : Optional.of("select one vertex"));
    }

    /** At least so many vertices are selected as well. */
    Supplier<Optional<String>> vertices(String id, int least) {
        return () -> actions.whyNotEdit(id)
                .or(() -> actions.edits().centres(actions.selection()).size() >= least
                        ? Optional.empty()
                        : Optional.of("select at least " + least + " vertices"));
    }
}
