package org.sami.crw.gui.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.palette.Theme;
import org.sami.ui.check.ShownColors;
import org.sami.ui.look.Look;
import org.sami.ui.window.WindowSettings;

@Isolated("the look is one for all windows of a process")
@Timeout(900)
class PanelColorsTest {
    @TempDir
    private Path folder;

    @AfterEach
    void back() {
        apply(Theme.LIGHT);
    }

    private static void apply(Theme theme) {
        onEventThread(() -> {
            Look.apply(theme, 100);
            return null;
        });
    }

    @Test
    void allColoursAreThoseOfTheLookAlsoWhenItChangesWhileTheWindowIsOpen() throws Exception {
        apply(Theme.DARK);
        List<String> wanted = colours(false);
        apply(Theme.LIGHT);

        assertThat(colours(true)).hasSizeGreaterThan(100).containsExactlyInAnyOrderElementsOf(wanted);
    }

    /** The colours of all panels, with a mission that asks something. */
    private List<String> colours(boolean changed) throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("connect-boat"))) {
            OperatorPanels panels = onEventThread(() -> new OperatorPanels(
                    world.context,
                    new WindowSettings(folder.resolve("settings")),
                    new LoadedProject(Optional.empty())));
            world.start("connect-boat");
            until(
                    "it asks",
                    () -> !world.context.models().decisions().snapshot().isEmpty());
            return onEventThread(() -> {
                panels.refresh();
                if (changed) {
                    Look.apply(Theme.DARK, 100);
                    panels.all().forEach(SwingUtilities::updateComponentTreeUI);
                }
                List<String> colours = panels.all().stream()
                        .flatMap(panel -> ShownColors.of(panel).stream())
                        .toList();
                panels.close();
                return colours;
            });
        }
    }
}
