package org.sami.crw.gui.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;
import static org.sami.crw.gui.SessionWorld.find;
import static org.sami.crw.gui.SessionWorld.laidOut;
import static org.sami.crw.gui.SessionWorld.text;
import static org.sami.crw.gui.SessionWorld.until;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.palette.SemanticColor;
import org.sami.ui.window.WindowSettings;

/** No mission looks as if it ran while the engine does not work. */
@Timeout(900)
class StandingStillTest {
    @TempDir
    private Path folder;

    @Test
    void aMissionStandsStillInAmberOnceTheEngineHasStoppedAndButtonsSayWhy() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"), "anna")) {
            MissionStarter starter = new MissionStarter(
                    world.context, new WindowSettings(folder.resolve("settings")), world.editors(), values -> {});
            MissionMonitor monitor = laidOut(() ->
                    new MissionMonitor(world.context, starter, world.editors(), new LoadedProject(Optional.empty())));
            world.start("clv");
            until("it runs", () -> text(monitor, "mission-state").startsWith("runs since"));

            world.session.host().fail("memory ran out");

            until("it stands still", () -> text(monitor, "mission-state").startsWith("stands still, runs since"));
            assertThat(onEventThread(
                            () -> find(monitor, "mission-state", JLabel.class).getForeground()))
                    .isEqualTo(SemanticColor.WARNING.get());
            List<String> refused = new CopyOnWriteArrayList<>();
            onEventThread(() -> {
                world.context.notices().addListener(notice -> refused.add(notice.text()));
                return null;
            });
            onEventThread(() -> {
                starter.start(SessionWorld.library("clv").plan("clv").orElseThrow()); // as the button does
                return null;
            });
            until("it says why", () -> refused.stream().anyMatch(text -> text.contains("memory ran out")));
        }
    }
}
