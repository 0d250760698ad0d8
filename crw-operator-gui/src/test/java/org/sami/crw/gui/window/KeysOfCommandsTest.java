package org.sami.crw.gui.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.ui.command.Command;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

@Timeout(900)
class KeysOfCommandsTest {
    /** What is chosen in a form next to its values, or once a season. */
    private static final String WITHOUT = "boat-set-.*|alarm-hear-.*|map-base-stop";

    @TempDir
    private Path folder;

    @Test
    void whatAnOperatorDoesAfloatHasAKeyOfItsOwn() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            List<String> without = onEventThread(() -> {
                WindowSettings settings = new WindowSettings(folder.resolve("settings"));
                OperatorPanels panels =
                        new OperatorPanels(world.context, settings, new LoadedProject(Optional.empty()));
                new ViewCommands(world.context.commands(), null, settings);
                panels.close();
                return world.context.commands().all().stream()
                        .filter(command -> command.keyText().isEmpty())
                        .map(Command::id)
                        .toList();
            });

            assertThat(without).allMatch(id -> id.matches(WITHOUT));
        }
    }
}
